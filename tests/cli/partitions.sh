# A partition on floors that run on below it: the sealed room behind it is dark.
. "$2/tests/cli/check.sh"

# usage: flat X, a room of 6.1 x 3 x 4 m with a lamp and a wall at X; if $modelled is outward, its shell looks that way
flat() {
    printf 'newmtl white\nKd .7\nnewmtl lamp\nKd 0\nKe 10\n' >flat.mtl
    awk -v x="$1" -v modelled="$modelled" 'function quad(a, b, c, d) { print "v", a; print "v", b; print "v", c; print "v", d; print "f -4 -3 -2 -1" }
    function shell(a, b, c, d) { if (modelled == "outward") quad(d, c, b, a); else quad(a, b, c, d) }
    BEGIN { print "mtllib flat.mtl\nusemtl white\no floor"
        shell("0 0 0", "0 0 4", "6.1 0 4", "6.1 0 0"); print "o shell"; shell("0 3 0", "6.1 3 0", "6.1 3 4", "0 3 4")
        shell("0 0 0", "6.1 0 0", "6.1 3 0", "0 3 0"); shell("6.1 0 4", "0 0 4", "0 3 4", "6.1 3 4")
        shell("0 0 4", "0 0 0", "0 3 0", "0 3 4"); shell("6.1 0 0", "6.1 0 4", "6.1 3 4", "6.1 3 0"); print "o wall"
        quad(x " 0 0", x " 3 0", x " 3 4", x " 0 4"); quad(x " 0 0", x " 0 4", x " 3 4", x " 3 0")
        print "usemtl lamp\no lamp"; quad("1 2.99 1.5", "2 2.99 1.5", "2 2.99 2.5", "1 2.99 2.5") }' >flat.obj
}

# The power that surfaces reflect beyond x, over that before x, is at most LIMIT.
# usage: is_dark X LIMIT ARGS...
is_dark() {
    x=$1 limit=$2
    shift 2
    flat "$x" && ends 0 solve flat.obj -q -o flat.csv "$@" || return
    awk -F, -v x="$x" -v limit="$limit" '/^[0-9]/ { if ($4 + 1e-4 * $7 > x) dark += $10 * $17; else lit += $10 * ($17 - $14) }
        END { print dark / lit; exit !(lit > 0 && dark <= limit * lit) }' flat.csv
}
for x in 3.1 2.57 5.4; do
    check "adaptive patches: dark beyond $x" is_dark $x 1e-5
    check "1000 patches: dark beyond $x" is_dark $x 1e-5 --patches 1000
done

modelled=outward
check "dark in a shell that is turned, too" is_dark 2.57 1e-5 --patches 1000
modelled=

told() { flat 3.1 && ends 0 check flat.obj && says out "4 surfaces cut into 8 where partitions stand"; }
check "the cuts are told" told

meshes() {
    flat 3.1 && ends 0 solve flat.obj -q --patches 300 --lines 2^12 -o flat.state -o first.glb &&
        ends 0 render flat.state -q -o again.glb && cmp first.glb again.glb
}
check "a state keeps the cut surfaces" meshes

finish
