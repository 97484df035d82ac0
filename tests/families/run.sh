#!/bin/sh
# Measures all methods on families of generated rooms (room.awk):
#   sh tests/families/run.sh PROGRAM FOLDER [FAMILY ...]
# Every line of FOLDER/rooms.csv is one method in one room: its relative mean square error, the mean of four executions
# against line reuse with 16 times the lines, and its processor time on one thread. FOLDER keeps the finished executions,
# so that the script goes on where it was. figure.awk draws a family, map.awk all rooms.
set -e
here=$(cd "$(dirname "$0")" && pwd)
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
mkdir -p "$2" && cd "$2"
shift 2
[ $# -gt 0 ] || set -- furniture building pillars courtyard lamps

# measure FAMILY SIZE PATCHES LINES_PER_PATCH [OPTION ...]
measure() {
    family=$1 size=$2 patches=$3 per_patch=$4 name=$1-$2
    shift 4
    [ -f "$name.obj" ] || awk -v family="$family" -v size="$size" -v out="$name.obj" -f "$here/room.awk"
    "$program" check "$name.obj" -n 2^16 --patches "$patches" --json "$@" >check.json 2>/dev/null || [ $? -eq 3 ]
    real=$(sed -n 's/^  "patches": \([0-9]*\),$/\1/p' check.json)
    crossings=$(sed -n 's/^  "intersections": \([0-9.]*\),$/\1/p' check.json)
    lines=$((per_patch * real))
    [ $lines -le 4000000 ] || return 0 # minutes for a room
    "$program" study "$name.obj" --patches "$patches" --methods all --sequences sobol-owen --from $lines --to $lines \
        --replicates 4 --cache cache -q -o point.csv "$@"
    awk -F, -v OFS=, -v room="$family,$size,$real,$crossings,$per_patch" '!/^#/ && NR > 1 && $1 != "method" { print room, $1, $7, $8, $9 }' point.csv >>rooms.new
    echo "$name: $real patches, $per_patch lines for each" >&2
}

echo "family,size,patches,crossings,lines_per_patch,method,relative_mse,standard_error,seconds" >rooms.new
for family; do
    for effort in "500 64" "4000 64" "500 512"; do
        case $family in
        furniture) for size in 0 10 100 1000 10000; do measure $family $size $effort; done ;;
        building) for size in 1 4 16 36 100; do measure $family $size $effort; done ;;
        pillars) for size in 16 64 256 1024; do measure $family $size $effort; done ;;
        courtyard) for size in 0 10 100 1000; do measure $family $size $effort --sky 10; done ;;
        lamps) for size in 1 10 100 1000 10000; do measure $family $size $effort; done ;;
        *) echo "no family is called $family" >&2; exit 2 ;;
        esac
    done
done
mv rooms.new rooms.csv
