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
        END { print "largest relative difference:", worst, "of", rows, "patches"; exit !(rows == patches && rows > 100 && sum > 0 && worst <= largest) }' \
        mini.csv program.csv
}

# usage: agrees SCENE LINES PASSES PATCH_SIZE POWER_BY_LINE METHOD
agrees() {
    power=
    [ "$3" = 0 ] || power="--power-per-line $5"
    ./mini "$root/scenes/$1.obj" "$2" "$3" "$4" "$5" >mini.txt && # options apart
        ends 0 solve "$root/scenes/$1.obj" --lines "$2" --patch-size "$4" --method "$6" $power $quiet && same 1e-10
}
check "5CUBES: first shot and walk" agrees 5cubes 50000 1 0.15 1e-3 first-shot
check "5CUBES: extended first shot and walk" agrees 5cubes 50000 1000 0.15 1e-3 extended
for scene in 4chairs 4chairs-up; do
    check "$scene: first shot and walk" agrees $scene 20000 1 0.15 5e-3 first-shot
    check "$scene: extended first shot and walk" agrees $scene 20000 1000 0.15 5e-3 extended
done
check "5CUBES: most lines for the shots" agrees 5cubes 120000 1000 0.15 1e-4 extended
check "global lines alone" agrees 5cubes 50000 0 0.15 1 global
check "triangles, and colours" agrees sphere 15000 1000 0.2 1e-2 extended
check "a room with an open front" agrees cornell 50000 1000 0.05 1e-3 extended

pictured() { [ "$(head -c 2 mini.ppm)" = P6 ] && tail -c 921600 mini.ppm | od -An -v -tu1 | awk '{ for (i = 1; i <= NF; ++i) s += $i } END { exit s / 921600 < 10 }'; }
check "it writes a picture" pictured
finish
