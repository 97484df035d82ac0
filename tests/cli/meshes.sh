# Solved meshes as a user gets them: PLY, GLB and OBJ.
. "$2/tests/cli/check.sh"
scene=$root/scenes/5cubes.obj
quick="--lines 20000 --patch-size 0.5 --quiet"

same_bytes() {
    for threads in 1 2; do
        ends 0 solve "$scene" $quick --threads $threads -o $threads.ply -o $threads.glb -o $threads.obj || return
    done
    cmp 1.ply 2.ply && cmp 1.glb 2.glb && cmp 1.obj 2.obj
}
check "one and two threads give the same bytes" same_bytes

# usage: has FILE TEXT
has() { grep -aqF -e "$2" "$1" || { echo "'$2' is not in $1"; return 1; }; }

records() {
    for file in 1.ply 1.glb 1.obj; do
        for fact in "multipath solve " " --lines 20000" "seed: 1" "scene: "; do has $file "$fact" || return; done
    done
    has 1.ply "comment command: " && has 1.obj "# command: " && has 1.glb '"record": ["multipath '
}
check "each says where it comes from" records

small() { ends 0 solve "$root/scenes/4chairs.obj" --lines 2^14 --quiet -o 4chairs.glb && [ "$(wc -c <4chairs.glb)" -lt 2000000 ]; }
check "the room with four chairs has less than 2 MB" small

errors() {
    ends 0 solve "$scene" $quick --replicates 2 -o error.ply -o error.glb && has error.ply "property float error_b" &&
        has error.glb '"_ERROR"' && ! has 1.ply error_b && ! has 1.glb _ERROR
}
check "with replicates they hold the standard error" errors

# usage: vertices PLY
vertices() { sed -n 's/^element vertex //p' "$1"; }

shading() {
    ends 0 solve "$scene" $quick --shading flat -o flat.ply &&
        [ "$(vertices flat.ply)" -gt $((2 * $(vertices 1.ply))) ] 2>/dev/null ||
        { echo "$(vertices flat.ply) flat, $(vertices 1.ply) smooth"; return 1; }
}
check "flat patches have vertices of their own" shading

shown() {
    ends 0 solve "$scene" $quick --show patches -o patches.png -o patches.ply || return
    for file in 1.ply patches.ply; do tail -c 20000 $file >$file.end; done
    cmp 1.ply.end patches.ply.end
}
check "whatever pictures show, meshes hold the radiosity" shown

brighter() {
    ends 0 solve "$scene" $quick --exposure 1 -o bright.obj -o bright.glb || return
    for file in 1.obj bright.obj; do awk '$1 == "v" { s += $5; n++ } END { print int(1000 * s / n) }' $file; done >brightness
    [ "$(tail -n 1 brightness)" -gt "$(head -n 1 brightness)" ] || { cat brightness; return 1; }
    scale() { tr ',' '\n' <"$1" | sed -n 's/.*"color_scale": \([0-9.e+-]*\).*/\1/p' | head -n 1; }
    awk -v a="$(scale 1.glb)" -v b="$(scale bright.glb)" 'BEGIN { exit !(b > 1.999 * a && b < 2.001 * a) }' ||
        { scale 1.glb; scale bright.glb; return 1; }
}
check "exposure is that of pictures" brighter

# A carpet in the plane of the floor: what of the floor lies under it is in no mesh, as in no picture.
covered() {
    printf 'newmtl grey\nKd .5 .5 .5\nnewmtl lamp\nKe 1 1 1\n' >floor.mtl
    {
        printf 'mtllib floor.mtl\nusemtl grey\nv 0 0 0\nv 0 0 4\nv 4 0 4\nv 4 0 0\nf 1 2 3 4\nv 1 0 1\nv 1 0 3\nv 3 0 3\nv 3 0 1\nf 5 6 7 8\n'
        printf 'usemtl lamp\nv 0 3 0\nv 1 3 0\nv 1 3 1\nv 0 3 1\nf 9 10 11 12\n'
    } >floor.obj
    ends 0 solve floor.obj --patch-size 1 --lines 2^12 --quiet -o floor.csv -o floor.ply -o floor.obj.glb -o lit.obj -o floor.html || return
    patches=$(grep -c '^[0-9]' floor.csv) && has floor.ply "element face $((patches - 4))" && [ "$(grep -c '^f ' lit.obj)" -eq $((patches - 4)) ] &&
        ! has floor.html '"covered": ""' && ends 0 solve "$scene" $quick -o whole.html && has whole.html '"covered": ""'
}
check "what lies under another face of its plane is left out" covered

not_the_scene() {
    cp "$scene" room.obj && cp "$root/scenes/5cubes.mtl" . && ends 2 solve room.obj $quick -o ./room.obj &&
        says err "is an input" && cmp "$scene" room.obj
}
check "the lit scene never replaces the scene" not_the_scene
finish
