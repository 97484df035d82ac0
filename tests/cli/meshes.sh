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

# The same room where maps have their coordinates: whatever is written of it is that of the room, moved.
far_away() {
    cp "$root/scenes/cornell.obj" near.obj && cp "$root/scenes/cornell.mtl" . &&
        awk '$1 == "v" { printf "v %.9f %.9f %.9f\n", $2 + 500000, $3 + 120, $4 + 4649776; next } { print }' near.obj >far.obj || return
    for room in near far; do
        ends 0 solve $room.obj --lines 2^12 --patch-size 0.2 -o $room.ply -o $room-lit.obj -o $room.csv && cp err $room.err &&
            ends 0 solve $room.obj --lines 2^12 --patch-size 0.2 --quiet --grid 0.2,0.1 -o $room-grid.csv || return
        sed -n 's/^v \([^ ]* [^ ]* [^ ]*\).*/\1/p' $room-lit.obj >$room.places
        grep '^[0-9]' $room-grid.csv | tr ',' ' ' >>$room.places
    done
    says far.err "warning    far.ply: the seven digits" && says far.err "less (500000.5, 120.5, 4649776.5)" &&
        ! grep warning near.err | grep -q ply && has far.ply "comment offset: 500000.5 120.5 4649776.5" && ! has near.ply "comment offset" || return
    paste -d ' ' near.places far.places | awk '{
        n = NF / 2; d[1] = $(n + 1) - $1 - 500000; d[2] = $(n + 2) - $2 - 120; d[3] = $(n + 3) - $3 - 4649776
        for (k = 1; k <= 3; ++k) if (d[k] > 1e-6 || d[k] < -1e-6) { print; ++wrong } }
        END { exit wrong || NR < 150 }' || return
    ends 0 check far.obj && says out "from (500000, 120, 4649776) to (500000.55, 120.55, 4649776.56)" &&
        ends 0 solve far.obj --lines 2^11 --patch-size 0.2 --quiet -o fewer.csv && ends 0 compare fewer.csv far.csv
}
check "far from the origin coordinates are as exact as near it" far_away

not_the_scene() {
    cp "$scene" room.obj && cp "$root/scenes/5cubes.mtl" . && ends 2 solve room.obj $quick -o ./room.obj &&
        says err "is an input" && cmp "$scene" room.obj
}
check "the lit scene never replaces the scene" not_the_scene
finish
