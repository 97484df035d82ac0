# Meshes and pictures as independent programs read them: three.js (in node, and in a browser), Khronos' validator, assimp,
# ImageMagick.
# usage: readers.sh PROGRAM ROOT [SCREENSHOT]     in an empty folder; needs node, npm, assimp, ImageMagick with OpenEXR and
# a browser (CHROMIUM)
. "$2/tests/cli/check.sh"
screenshot=${3:-inside.png}
chromium=${CHROMIUM:-chromium}
cp "$root"/tests/readers/*.mjs "$root"/tests/readers/*.cjs "$root"/tests/readers/*.html .

fetched() { npm install --no-audit --no-fund --no-save three@0.187.0 gltf-validator@2.0.0-dev.3.10; }
check "the readers are there" fetched

inks=$(tr -d ' \n' <<HEX
ffd8ffee000e41646f626500640000000002ffdb0043001b12141714111b1716171e1c1b2028422b28252528513a3d3042605565645f555d
5b6a7899816a7190735b5d85b586909ea3abadab6780bcc9baa6c799a8aba4ffdb0043011c1e1e2823284e2b2b4ea46e5d6ea4a4a4a4a4a4
a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4ffc000140800030005040111
00021101031101041100ffc40014000100000000000000000000000000000005ffc4001b1000010403000000000000000000000000010002
1112214271ffc4001501010100000000000000000000000000000205ffc4001811000203000000000000000000000000000011010321ffda
000e040100021103110400003f001d8019e056a474eb6396356e750bffd9
HEX
)
solved() {
    for shading in flat smooth; do
        ends 0 solve "$root/scenes/4chairs.obj" --lines 2^17 --quiet --shading $shading -o $shading.csv -o $shading.ply \
            -o $shading.glb -o $shading.obj || return
    done
    node slanted_room.mjs && ends 0 solve slanted.obj --lines 2^14 --patch-size 0.17 --quiet -o slanted.glb || return
    ends 0 solve "$root/scenes/sphere.obj" --lines 2^14 --replicates 2 --two-sided --quiet -o sphere.glb || return
    # The walls of the room in black and white, its floor and ceiling from files that glTF cannot hold: one of text, and a
    # JPEG of inks.
    node -e "fs.writeFileSync('inks.jpg', Buffer.from('$inks', 'hex'))" || return
    printf 'P3 2 2 255\n255 255 255 0 0 0\n0 0 0 255 255 255\n' >checks.ppm
    "$program" solve "$root/scenes/4chairs.obj" --lines 2^14 --quiet --show normals --size 64x48 -o walls.png || return
    sed '/^mtllib/d; s/^f \(.*\) \(.*\) \(.*\) \(.*\)$/f \1\/1 \2\/2 \3\/3 \4\/4/' "$root/scenes/4chairs.obj" >faces.obj
    { echo 'mtllib textured.mtl'; printf 'vt 0 0\nvt 4 0\nvt 4 4\nvt 0 4\n'; cat faces.obj; } >textured.obj
    sed 's/^newmtl floor/&\nmap_Kd checks.ppm/; s/^newmtl wall.*/&\nmap_Kd -clamp on walls.png/; s/^newmtl ceiling/&\nmap_Kd inks.jpg/' "$root/scenes/4chairs.mtl" >textured.mtl
    ends 0 solve textured.obj --lines 2^16 --quiet -o textured.glb -o textured.png &&
        ends 0 solve "$root/scenes/4chairs.obj" --lines 2^16 --quiet -o 4chairs_lightmap.glb || return
    # The same with z upwards, where maps have it, with backs and two views; and two triangles of a tenth of a
    # millimetre, with a third under one of them.
    awk '$1 == "v" { printf "v %.9f %.9f %.9f\n", $2 + 500000, 4649776 - $4, $3 + 120; next } { print }' textured.obj >map.obj || return
    for view in door window; do
        echo '{"eye": [500001.8, 4649774.7, 121.7], "target": [500000, 4649776, 121], "up": [0, 0, 1]}' >$view.json
    done
    ends 0 solve map.obj --lines 2^14 --camera door.json --camera window.json --two-sided --quiet -o map.glb || return
    { echo "mtllib $root/scenes/4chairs.mtl"; sed '/^mtllib/d' map.obj; } >plain_map.obj # textures take long in lightmaps
    ends 0 solve plain_map.obj --lines 2^12 --camera door.json --camera window.json --two-sided --quiet -o map_lightmap.glb || return
    printf 'newmtl "a lamp"\nKe 1 1 1\nnewmtl \303\251\nKd 0.5 0.5 0.5\nnewmtl under\nKd 0.5 0.5 0.5\n' >small.mtl
    {
        printf 'mtllib small.mtl\nv 0 0 0\nv 1e-4 0 0\nv 0 0 1e-4\nv 0 1e-4 0\nv 1e-4 1e-4 0\nv 0 1e-4 1e-4\n'
        printf 'usemtl \303\251\nf 1 3 2\nusemtl "a lamp"\nf 4 5 6\nusemtl under\nf 1 3 2\n'
    } >small.obj
    ends 0 solve small.obj --lines 2^10 --quiet -o small.glb
}
check "solve writes the meshes" solved

check "three.js reads the areas, powers and names of the table, and finds rooms upright and at their places" node three_loaders.mjs
check "Khronos' validator finds nothing wrong" node validate.cjs ./*.glb

assimp_reads() {
    for kind in ply glb obj; do assimp export flat.$kind $kind.json -fassjson || return; done
    node assimp_meshes.mjs
}
check "assimp reads the areas, colours and names" assimp_reads

# ImageMagick clips at 1. Half floats have 11 bits, the channels of RGBE 8 below that of the largest.
# usage: same_numbers FILE ERROR       ERROR: in a channel, as a share of the largest channel of the pixel
same_numbers() {
    convert "$1" -set colorspace sRGB -flip -depth 16 -endian LSB rgb:numbers && od -An -v -tu2 -w6 numbers >read &&
        tail -n +4 linear.pfm | od -An -v -tf4 -w12 | paste - read | awk -v error="$2" '
            { most = $1 > $2 ? $1 : $2; most = most > $3 ? most : $3 }
            { for (k = 1; k <= 3; ++k) { e = $(k + 3) / 65535 - ($k < 1 ? $k : 1); bad += e * e > (error * most + 1e-5) ^ 2 } }
            most > 0.01 && most < 1 { ++inside }
            END { exit !(bad == 0 && NR == 4800 && inside > 2000) }'
}
linear_pictures() {
    ends 0 solve "$root/scenes/5cubes.obj" --lines 2^15 --size 80x60 --quiet -o linear.pfm -o linear.exr -o linear.hdr &&
        same_numbers linear.exr 5e-4 && same_numbers linear.hdr 8e-3 &&
        grep -aq "command: multipath solve" linear.exr && grep -aq "command: multipath solve" linear.hdr
}
check "ImageMagick reads the pictures with numbers" linear_pictures

# usage: browse FILES OPTIONS...        files with commas between them
browse() {
    files=$1
    shift
    timeout 120 "$chromium" --headless --no-sandbox --hide-scrollbars --allow-file-access-from-files --use-gl=angle \
        --use-angle=swiftshader --enable-unsafe-swiftshader --host-resolver-rules="MAP * ~NOTFOUND" --virtual-time-budget=60000 \
        --window-size=900,700 "$@" "file://$PWD/inside.html?files=$files" 2>browser.log
}
seen_from_inside() {
    browse smooth.glb,flat.glb,slanted.glb,textured.glb,4chairs_lightmap.glb --dump-dom >dom.html && grep -q '^end$' dom.html && return
    head -c 2000 dom.html
    return 1
}
check "three.js draws the rooms in a browser" seen_from_inside

# usage: closed FILE.glb
closed() {
    sed -n 's/.*<pre id="result">//; /^file /,$p' dom.html | awk -v wanted="$1" '$1 == "file" { file = $2 } file == wanted' >seen
    grep -qx 'cracks 0' seen && awk '/^white/ { white = $2 } /^shades/ { shades = $2 } END { exit !(white > 1000 && shades > 500) }' \
        seen && return
    cat seen
    return 1
}
check "seen from inside, a smooth room has no crack, a white lamp and many shades" closed smooth.glb
check "a room of flat patches has no crack either" closed flat.glb
check "nor has a room whose walls are cut otherwise than its floor" closed slanted.glb
check "nor has one with textures" closed textured.glb
check "nor one of undivided surfaces with a lightmap" closed 4chairs_lightmap.glb

pictured() { browse smooth.glb --screenshot="$screenshot" && [ "$(wc -c <"$screenshot")" -gt 20000 ]; }
check "a screenshot is kept" pictured
finish
