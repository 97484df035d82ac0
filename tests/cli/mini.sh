# The paper in one file, docs/mini: built by a plain compiler, it gives what the program gives for the same lines, patch by
# patch, to rounding.
. "$2/tests/cli/check.sh"
quiet="--line-order sequence --quiet -o program.csv"

built() {
    for compiler in ${CXX:+"$CXX"} g++ clang++ c++; do
        command -v "$compiler" >/dev/null && "$compiler" -O2 -std=c++17 "$root/docs/mini/multipath_mini.cpp" -o mini && return
    done
}
check "it is built by one command" built

# usage: same LARGEST      relative difference of a patch, of what is brighter than a thousandth of the mean
same() {
    awk -F, -v largest="$1" '/^[0-9]/ && FNR == NR { for (k = 0; k < 3; ++k) { mini[$1, k] = $(NF - 2 + k); sum += $(NF - 2 + k) }; ++patches; next }
        /^[0-9]/ { for (k = 0; k < 3; ++k) { d = mini[$1, k] - $(NF - 2 + k); b = $(NF - 2 + k); m = sum / patches / 3000
                       if (b < m) b = m; if (d < 0) d = -d; if (d / b > worst) worst = d / b }; ++rows }
        END { print "largest relative difference:", worst, "of", rows, "patches"; exit !(rows == patches && rows > 60 && sum > 0 && worst <= largest) }' \
        mini.csv program.csv
}

# With the lines and the power of a ray that the other file tells.
# usage: agrees SCENE METHOD LINES PASSES PATCH_SIZE [POWER_BY_LINE]
agrees() {
    name=$1 method=$2 lines=$3 patch_size=$5
    shift 2
    ./mini "$root/scenes/$name.obj" "$@" >mini.txt 2>mini.err || return
    power="--power-per-line $(sed -n 's/.* rays of \([^ ]*\) W .*/\1/p' mini.txt)"
    [ "$method" != global ] || power=
    ends 0 solve "$root/scenes/$name.obj" --lines "$lines" --patch-size "$patch_size" --method "$method" $power $quiet &&
        same 1e-10
}

# Beside the same lines, a second method of the program with enough lines that its error is a tenth of the tolerance: 1 %, of
# which the light that stays unshot makes up to 0.7.
# usage: right SCENE METHOD PASSES
right() {
    agrees "$1" "$2" 1000000 "$3" 0.15 && silent mini.err &&
        ends 0 solve "$root/scenes/$1.obj" --patch-size 0.15 --lines 2^19 --json -q || return
    awk '/^mean radiosity/ { mini = $3 } /"mean_radiosity":/ { program = $2 + 0 }
        END { print "mean radiosity:", mini, "and", program; d = mini / program - 1; exit !(d * d < 1e-4) }' mini.txt out
}
for scene in 4chairs 4chairs-up 5cubes cornell cube furnace sphere squares; do # all but STUDIO: mini reads no textures
    check "$scene: its defaults give what the program gives, and what is right" right "$scene" extended 1000
done
for scene in 5cubes 4chairs-up; do
    check "$scene: first shot and walk, likewise" right $scene first-shot 1
done
./mini "$root/scenes/4chairs-up.obj" >mini.txt
./mini "$root/scenes/4chairs-up.obj" 1000000 1000 0.15 >given.txt
check "these are its defaults" cmp mini.txt given.txt

# Rooms that fill their box. The trial with a sixteenth of the lines misses by some thousandths in each pass.
# usage: shared_by_3 SCENE
shared_by_3() {
    ./mini "$root/scenes/$1.obj" 200000 1000 0.2 >mini.txt && ends 0 check "$root/scenes/$1.obj" || return
    awk '/ global lines/ { ratio = $5 / $13 } /^  \(3\)/ { wanted = $(NF - 1) }
        END { print "N_l / N_g:", ratio, "and", wanted; d = ratio / wanted - 1; exit !(d * d < 0.0016) }' mini.txt out
}
for scene in 5cubes 4chairs 4chairs-up cube cornell; do
    check "$scene: the lines are shared by (3)" shared_by_3 $scene
done

check "5CUBES: most lines for the shots" agrees 5cubes extended 120000 1000 0.15 1e-4
check "global lines alone" agrees 5cubes global 50000 0 0.15
check "triangles, and colours" agrees sphere extended 15000 1000 0.2
check "a room with an open front" agrees cornell extended 50000 1000 0.05
told() { ./mini "$root/scenes/5cubes.obj" 50000 1000 0.15 1e-4 2>mini.err >mini.txt; says mini.err "no lines are left for the walk"; }
check "it tells that no lines are left for the walk" told

pictured() { [ "$(head -c 2 mini.ppm)" = P6 ] && tail -c 921600 mini.ppm | od -An -v -tu1 | awk '{ for (i = 1; i <= NF; ++i) s += $i } END { exit s / 921600 < 10 }'; }
check "it writes a picture" pictured
finish
