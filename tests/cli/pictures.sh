# What pictures show of scenes that are not the bundled ones: where the camera stands.
. "$2/tests/cli/check.sh"

# The six faces of a box.
# usage: box X Y Z X Y Z in|out      the side from which they are seen
box() {
    awk -v side="$7" -v corners="$1 $2 $3 $4 $5 $6" 'BEGIN {
        split(corners, c, " ")
        for (k = 0; k < 8; ++k)
            print "v", c[k % 2 ? 4 : 1], c[int(k / 2) % 2 ? 5 : 2], c[k < 4 ? 3 : 6]
        faces = split("1 5 7 3;2 4 8 6;1 2 6 5;3 7 8 4;1 3 4 2;5 6 8 7", face, ";")
        for (k = 1; k <= faces; ++k) {
            split(face[k], p, " ")
            print "f", p[side == "out" ? 1 : 4] - 9, p[side == "out" ? 2 : 3] - 9, p[side == "out" ? 3 : 2] - 9, p[side == "out" ? 4 : 1] - 9
        }
    }'
}
lamp() { printf 'usemtl lamp\nv 3 2.9 2\nv 4 2.9 2\nv 4 2.9 3\nv 3 2.9 3\nf -4 -3 -2 -1\n'; }
ground() { printf 'usemtl plaster\nv -30 -0.2 -30\nv -30 -0.2 30\nv 30 -0.2 30\nv 30 -0.2 -30\nf -4 -3 -2 -1\n'; }
printf 'newmtl plaster\nKd .6 .6 .6\nnewmtl lamp\nKd 0 0 0\nKe 10 10 10\n' >house.mtl

# A house with a lamp inside, each wall of which has a face inside and one outside.
{
    printf 'mtllib house.mtl\nusemtl plaster\n'
    box 0 0 0 6 3 5 in && box -0.2 -0.2 -0.2 6.2 3.2 5.2 out && box 1 0 1 2 1 2 out && lamp
} >closed.obj
{ cat closed.obj && ground; } >closed_garden.obj

# The same with a window, as walls of which each is a box.
{
    printf 'mtllib house.mtl\nusemtl plaster\n'
    box 0 0 5 2 3 5.2 out && box 4 0 5 6 3 5.2 out && box 2 0 5 4 1 5.2 out && box 2 2.2 5 4 3 5.2 out &&
        box -0.2 -0.2 -0.2 6.2 0 5.2 out && box -0.2 3 -0.2 6.2 3.2 5.2 out && box -0.2 0 -0.2 0 3 5.2 out &&
        box 6 0 -0.2 6.2 3 5.2 out && box 0 0 -0.2 6 3 0 out && box 1 0 1 2 1 2 out && lamp
} >window.obj
{ cat window.obj && ground; } >window_garden.obj
quick="--lines 2^15 --patches 1000 --size 80x60"

# Prints how many of the 14,400 bytes of a picture are brighter than black.
bright_bytes() { tail -c 14400 "$1" | tr -d '\000-\017' | wc -c; }

# usage: inside_is_shown SCENE
inside_is_shown() {
    ends 0 solve $1.obj $quick -o $1.ppm && [ "$(bright_bytes $1.ppm)" -gt 12000 ]
}
for house in closed closed_garden window window_garden; do
    check "the lit inside of a house is shown: $house" inside_is_shown $house
done

same_view() {
    ends 0 solve closed.obj $quick --quiet -o kept.state -o kept.html -o kept.ppm && ends 0 render kept.state --size 80x60 -o again.ppm -o again.html ||
        return
    camera() { sed -n 's/.*"camera": {\([^}]*\)}.*/\1/p' "$1"; }
    tail -c 14400 kept.ppm >kept.pixels && tail -c 14400 again.ppm | cmp - kept.pixels && [ "$(camera kept.html)" ] &&
        [ "$(camera kept.html)" = "$(camera again.html)" ] && camera kept.html >kept.camera &&
        eye=$(sed 's/.*"eye": \[\([^]]*\)\].*/\1/; s/ //g' kept.camera) &&
        awk -v eye="$eye" 'BEGIN { split(eye, e, ","); exit !(e[1] > 0 && e[1] < 6 && e[2] > 0 && e[2] < 3 && e[3] > 0 && e[3] < 5) }'
}
check "the page and render stand where solve does, inside" same_view

# A view of the page's; of several each gets its picture, and what is no picture is written once.
views() {
    echo '{"eye": [3, 1.5, 4.5], "target": [3, 1, 0], "fov": 50}' >door.json
    echo '{"eye": [0.5, 1.5, 0.5], "target": [3, 1, 2]}' >corner.json
    ends 0 solve closed.obj $quick --camera door.json -o one.ppm -o views.state &&
        ends 0 solve closed.obj $quick --eye 3,1.5,4.5 --target 3,1,0 --fov 50 -o options.ppm &&
        ends 0 render views.state --size 80x60 --camera door.json --camera corner.json -o both.ppm -o both.glb -o both.csv &&
        says err "wrote      both-door.ppm" && [ ! -e both.ppm ] && ends 0 render views.state --size 80x60 --camera corner.json -o two.ppm || return
    for file in one options both-door both-corner two; do
        tail -c 14400 $file.ppm >$file.pixels
    done
    cmp one.pixels options.pixels && cmp one.pixels both-door.pixels && cmp two.pixels both-corner.pixels && ! cmp -s one.pixels two.pixels &&
        grep -aq '"name": "corner"' both.glb && ends 2 render views.state --size 80x60 --camera door.json --camera ./door.json -o x.ppm &&
        says err "two views are called" && ends 2 render views.state --size 80x60 --camera door.json --fov 40 -o x.ppm && says err "exclude each other" &&
        ends 2 render views.state --size 80x60 --camera door.json --camera corner.json -o - && says err "standard output takes one picture" &&
        ends 1 render views.state --size 80x60 --camera none.json -o x.ppm && says err "none.json: cannot be read"
}
check "views come from files, several at once" views

finish
