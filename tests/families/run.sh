#!/bin/sh
# Measures all methods on families of generated rooms (room.awk):
#   sh tests/families/run.sh PROGRAM FOLDER [FAMILY ...]
# Every line of FOLDER/rooms.csv is one method in one room: its relative mean square error with 64 lines per patch, the
# mean of four executions against line reuse with 16 times the lines, and its processor time on one thread. FOLDER keeps
# the finished executions, so that the script goes on where it was. figure.awk draws a family, map.awk all rooms.
set -e
here=$(cd "$(dirname "$0")" && pwd)
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
mkdir -p "$2" && cd "$2"
shift 2
[ $# -gt 0 ] || set -- furniture building pillars courtyard lamps

# measure FAMILY SIZE PATCHES [OPTION ...]
measure() {
    family=$1 size=$2 patches=$3 name=$1-$2
    shift 3
    [ -f "$name.obj" ] || awk -v family="$family" -v size="$size" -v out="$name.obj" -f "$here/room.awk"
    "$program" check "$name.obj" -n 2^16 --patches "$patches" --json "$@" >check.json 2>/dev/null || [ $? -eq 3 ]
    real=$(sed -n 's/^  "patches": \([0-9]*\),$/\1/p' check.json)
    crossings=$(sed -n 's/^  "intersections": \([0-9.]*\),$/\1/p' check.json)
    lines=$((64 * real))
    "$program" study "$name.obj" --patches "$patches" --methods all --sequences sobol-owen --from $lines --to $lines \
        --replicates 4 --cache cache -q -o point.csv "$@"
    awk -F, -v OFS=, -v room="$family,$size,$real,$crossings" '!/^#/ && NR > 1 && $1 != "method" { print room, $1, $7, $8, $9 }' point.csv >>rooms.new
    echo "$name: $real patches, $crossings crossings of a line" >&2
}

echo "family,size,patches,crossings,method,relative_mse,standard_error,seconds" >rooms.new
for family; do
    for patches in 500 4000; do
        case $family in
        furniture) for size in 0 10 100 1000 10000; do measure $family $size $patches; done ;;
        building) for size in 1 4 16 36 100; do measure $family $size $patches; done ;;
        pillars) for size in 16 64 256 1024; do measure $family $size $patches; done ;;
        courtyard) for size in 0 10 100 1000; do measure $family $size $patches --sky 10; done ;;
        lamps) for size in 1 10 100 1000 10000; do measure $family $size $patches; done ;;
        esac
    done
done
mv rooms.new rooms.csv
