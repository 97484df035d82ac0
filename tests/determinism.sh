# Compares the bytes of every output between builds, instruction sets and numbers of threads.
# A build is a program that exists, or a compiler with flags, such as "clang++ -O0", which is built into a folder of this
# name in build/. RUNS lists instruction sets and numbers of threads; those that the processor lacks are left out. The first
# build makes all of these runs, every other build the last one, with the methods in one of the three scenes. All are
# compared with the first run.
# Ends with the line "N passed, N failed".
# usage: [RUNS="avx512:1 plain:3"] determinism.sh BUILD...
[ $# -ge 1 ] || { echo "usage: determinism.sh BUILD..." >&2; exit 2; }
runs=${RUNS:-avx512:1 avx512:2 avx512:3 avx512:7 avx2:1 avx2:2 sse2:1 sse2:7 plain:1 plain:4}
root=$(cd "$(dirname "$0")/.." && pwd) || exit 1
scratch=$root/build/determinism passed=0 failed=0
rm -rf "$scratch" && mkdir -p "$scratch" && cd "$root" || exit 1
LC_ALL=C
export LC_ALL MULTIPATH_KERNELS

# Sets $program to the program of a build.
find_program() {
    program=$1
    [ -f "$1" ] && [ -x "$1" ] && { program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1"); return; }
    case $1 in *' '*) ;; *) echo "determinism.sh: '$1' is neither a program nor a compiler with flags" >&2; return 1 ;; esac
    folder=build/$(echo "$1" | tr -c 'a-zA-Z0-9+\n-' _)
    program=$root/$folder/multipath
    make CXX="${1%% *}" CXXFLAGS="${1#* }" BUILD="$folder" "$folder/multipath" >"$scratch/build.log" 2>&1 ||
        { cat "$scratch/build.log"; return 1; }
}

# usage: solved NAME EXTENSIONS SCENE OPTIONS...
solved() (
    name=$1 extensions=$2 scene=$3
    shift 3
    for extension in $extensions; do set -- "$@" -o "$name.$extension"; done
    "$program" solve -q "$scene" --threads "$threads" "$@" || echo "$name: exit status $?"
)

# Everything that is compared, in the folder of the run. Scenes have parallelograms, slanted ones, and triangles; so few
# surfaces that all are filtered, and so many that there is a hierarchy.
results() {
    ln -s "$root/scenes" scenes
    set -- random halton sobol-owen
    for scene in 4chairs 5cubes sphere; do
        case $methods_in in *$scene*) ;; *) continue ;; esac
        for method in $("$program" help methods | sed -n 's/^  \([a-z][a-z-]*\)  .*/\1/p'); do
            solved $scene-$method csv scenes/$scene.obj --patches 500 -n 2^13 -m $method -s "$1"
            set -- "$2" "$3" "$1"
        done
    done
    for scene in 5cubes 4chairs sphere; do
        solved $scene-two-sided csv scenes/$scene.obj --patches 500 -n 2^13 --two-sided
        solved $scene-gather pfm scenes/$scene.obj --patches 500 -n 2^13 --size 48x36 --shading gather --gather-rays 4 --samples 1
    done
    solved all "csv ppm png pfm ply glb obj html" scenes/4chairs.obj --patches 400 -n 2^13 --size 48x36
    solved replicates csv scenes/squares.obj --patches 500 -n 2^13 --replicates 3
    solved shot-reuse csv scenes/5cubes.obj --patches 500 -n 2^13 --direct shoot -s kronecker-shift
    solved adaptive csv scenes/5cubes.obj --adaptive 600 -n 2^12
    solved absorption csv scenes/5cubes.obj --patches 500 -n 2^13 -m local --estimator absorption
    solved one-way csv scenes/4chairs-up.obj --patches 500 -n 2^13 -m global --bidirectional no --chords box --pairing 2d --line-order sequence
    for shard in 1 2; do solved shard-$shard state scenes/5cubes.obj --patches 500 -n 2^14 --shard $shard/2; done
    "$program" merge shard-1.state shard-2.state -q --threads "$threads" -o merged.csv -o merged.state || echo "merge: $?"
    "$program" render merged.state -q --threads "$threads" --size 48x36 -o rendered.ppm || echo "render: exit status $?"
    "$program" check scenes/4chairs-up.obj -n 2^13 --threads "$threads" >check.txt || echo "check: exit status $?"
    "$program" explain scenes/4chairs.obj -n 3 --of 2^13 --threads "$threads" -o lines.svg >explain.txt || echo "explain: $?"
    "$program" points -d 4 -s halton-permuted --discrepancy -o points.csv >points.txt || echo "points: exit status $?"
    "$program" study scenes/5cubes.obj -q -m extended,reuse --from 2^10 --to 2^11 --replicates 2 --patches 200 \
        --threads "$threads" -o study.svg || echo "study: exit status $?"
    "$program" compare 4chairs-reuse.csv 4chairs-local.csv >compare.txt || echo "compare: exit status $?"
    rm -r scenes study.cache
}

# usage: same_bytes        by the current program, instruction set and number of threads
same_bytes() {
    folder=$scratch/run
    rm -rf "$folder" && mkdir -p "$folder"
    (cd "$folder" && results) >"$folder/errors.txt" 2>&1
    (cd "$folder" && cksum -- *) >"$scratch/these"
    [ -f "$scratch/first" ] || { mv "$scratch/these" "$scratch/first" && mv "$folder" "$scratch/expected"; return; }
    # What a run lacks that should be there is told in errors.txt.
    awk 'NR == FNR { made[$3]; next } $3 in made' "$scratch/these" "$scratch/first" >"$scratch/those"
    cmp -s "$scratch/those" "$scratch/these" && return
    diff "$scratch/those" "$scratch/these" | sed -n 's/^[<>] [0-9]* [0-9]* /  differs: /p' | sort -u
    cat "$folder/errors.txt"
    return 1
}

methods_in="4chairs 5cubes sphere"
for build in "$@"; do
    find_program "$build" || { echo "FAILED: no build '$build'"; failed=$((failed + 1)); continue; }
    for run in $runs; do
        MULTIPATH_KERNELS=${run%:*} threads=${run#*:}
        "$program" --version | grep -q "^instruction sets: $MULTIPATH_KERNELS" || { echo "left out: $run"; continue; }
        if same_bytes; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            echo "FAILED: other bytes from $build, $run"
        fi
    done
    runs=${runs##* } methods_in=4chairs
done
[ -s "$scratch/expected/errors.txt" ] && { cat "$scratch/expected/errors.txt"; failed=$((failed + 1)); }
echo "$passed passed, $failed failed"
[ $failed -eq 0 ] && [ $passed -gt 1 ]
