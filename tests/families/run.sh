#!/bin/sh
# Measures all methods on families of generated rooms (room.awk):
#   sh tests/families/run.sh PROGRAM FOLDER [FAMILY ...]
# Every line of FOLDER/rooms.csv is one method in one room: its relative mean square error, the mean of four executions
# against line reuse with 16 times the lines, its processor time on one thread, and the most memory of a `solve` with the
# same lines [MB] (GNU time). Where up to 100 boxes or lamps stand among boxes at random, it is the mean of three layouts,
# and the standard error is that of the layouts. extended-pilot is `--ratio measured`, reuse-raw is `--denoise no`.
# FOLDER keeps the finished executions, so that the script goes on where it was. figure.awk draws a family, map.awk all rooms.
set -e
here=$(cd "$(dirname "$0")" && pwd)
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
mkdir -p "$2" && cd "$2"
shift 2
[ $# -gt 0 ] || set -- furniture building pillars courtyard lamps

# rows METHODS [OPTION ...]: of the room in $name.obj, with the names of the methods followed by $suffix.
rows() {
    methods=$1
    shift
    "$program" study "$name.obj" --patches "$patches" --methods "$methods" --sequences sobol-owen --from $lines --to $lines \
        --replicates 4 --cache cache -q -o point.csv "$@"
    for method in $(awk -F, '!/^#/ && $1 != "method" { print $1 }' point.csv); do
        memory=$(/usr/bin/time -f %M "$program" solve "$name.obj" --patches "$patches" --method $method --threads 1 \
            --sequence sobol-owen --lines $lines -q -o memory.csv "$@" 2>&1 | tail -n 1)
        awk -F, -v OFS=, -v method=$method -v name="$method$suffix" -v room="$real,$crossings" -v memory=$memory \
            '$1 == method { print room, name, $7, $8, $9, memory / 1024 }' point.csv >>layouts.csv
    done
}
# measure FAMILY SIZE PATCHES LINES_PER_PATCH LAYOUTS [OPTION ...]
measure() {
    family=$1 size=$2 patches=$3 per_patch=$4 layouts=$5
    shift 5
    : >layouts.csv
    for seed in $(seq $layouts); do
        name=$family-$size-$seed suffix=
        [ -f "$name.obj" ] || awk -v family="$family" -v size="$size" -v seed=$seed -v out="$name.obj" -f "$here/room.awk"
        "$program" check "$name.obj" -n 2^16 --patches "$patches" --json "$@" >check.json 2>/dev/null || [ $? -eq 3 ]
        real=$(sed -n 's/^  "patches": \([0-9]*\),$/\1/p' check.json)
        crossings=$(sed -n 's/^  "intersections": \([0-9.]*\),$/\1/p' check.json)
        lines=$((per_patch * real))
        [ $lines -le 4000000 ] || return 0 # minutes for a room
        rows all "$@"
        suffix=-pilot
        rows extended --ratio measured "$@"
        suffix=-raw
        rows reuse --denoise no "$@"
    done
    awk -F, -v OFS=, -v room="$family,$size" -v lines=$per_patch '
        !($3 in count) { method[methods++] = $3 }
        { ++count[$3]; patches += $1; crossings += $2; error[$3] += $4; squares[$3] += $4 * $4; own[$3] = $5; seconds[$3] += $6; memory[$3] += $7 }
        END {
            for (k = 0; k < methods; ++k) {
                m = method[k]; n = count[m]; e = error[m] / n; spread = squares[m] / n - e * e
                print room, int(patches / NR + 0.5), crossings / NR, lines, m, e, (n > 1 ? sqrt(spread > 0 ? spread / (n - 1) : 0) : own[m]),
                    seconds[m] / n, int(memory[m] / n + 0.5), n
            }
        }' layouts.csv >>rooms.new
    echo "$family $size: $real patches, $per_patch lines for each" >&2
}

echo "family,size,patches,crossings,lines_per_patch,method,relative_mse,standard_error,seconds,memory_mb,layouts" >rooms.new
for family; do
    for effort in "500 64" "4000 64" "500 512"; do
        case $family in
        furniture) for size in 0 10 100 1000 10000; do measure $family $size $effort $((size == 0 || size > 100 ? 1 : 3)); done ;;
        building) for size in 1 4 16 36 100; do measure $family $size $effort 1; done ;;
        pillars) for size in 16 64 256 1024; do measure $family $size $effort 1; done ;;
        courtyard) for size in 0 10 100 1000; do measure $family $size $effort $((size == 0 || size > 100 ? 1 : 3)) --sky 10; done ;;
        lamps) for size in 1 10 100 1000 10000; do measure $family $size $effort $((size > 100 ? 1 : 3)); done ;;
        *) echo "no family is called $family" >&2; exit 2 ;;
        esac
    done
done
mv rooms.new rooms.csv
