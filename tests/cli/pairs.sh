# Two ways to say the same give the same light: most faults of readers, options and states change only one of them. The
# room is slanted and off the origin, has triangles, covered faces and thin sheets, and each wall is of another colour.
. "$2/tests/cli/check.sh"

cat >grid.obj <<'END'
mtllib room.mtl
v 0 0 0
v 4 0 0
v 4 0 3
v 0 0 3
v 0 2.5 0
v 4 2.5 0
v 4 2.5 3
v 0 2.5 3
v 1 2.2 0.8
v 2 2.2 0.8
v 2 2.2 1.6
v 1 2.2 1.6
v 2.5 0 0.5
v 3.5 0 0.5
v 3.5 0 1.5
v 2.5 0 1.5
v 2.5 0.9 0.5
v 3.5 0.9 0.5
v 3.5 0.9 1.5
v 2.5 0.9 1.5
v 0.5 0.6 2.5
v 1.9 0.5 2.2
v 0.8 1.4 1.4
vt 0 0
vt 2 0.5
vt 2.5 1.5
vt 0.5 1
o floor
usemtl floor
f 1 4 3 2
o box
usemtl chest
f 17/2 20/1 19/4 18/3
f 13 17 18 14
f 16 15 19 20
f 13 16 20 17
f 14 18 19 15
o walls
usemtl ceiling
f 5 6 7 8
usemtl north
f 1 2 6 5
usemtl south
f 4/1 8/2 7/3 3/4
usemtl west
f 1 5 8 4
usemtl east
f 2 3 7 6
o lights
usemtl lamp
f 9/1 10/2 11/3 12/4
o board
usemtl board
f 21/1 22/2 23/4
o backs
usemtl back
f 21 23 22
usemtl plate
f 9 12 11 10
END
cat >room.mtl <<'END'
newmtl floor
Kd 0.6 0.5 0.4
newmtl chest
Kd 0.4 0.25 0.1
newmtl ceiling
Kd 0.8 0.85 0.75
newmtl north
Kd 0.7 0.3 0.2
newmtl south
Kd 0.5 0.45 0.55
newmtl west
Kd 0.2 0.4 0.7
newmtl east
Kd 0.55 0.6 0.5
newmtl lamp
Kd 0.1 0.15 0.1
Ke 32 28 20
newmtl board
Kd 0.65 0.1 0.5
newmtl back
Kd 0.25 0.6 0.3
newmtl plate
Kd 0.3 0.35 0.3
END

# Vertices times a matrix, row by row, plus a shift; faces with their corners in the other order; texture points scaled and shifted.
# usage: placed MATRIX SHIFT
placed() {
    awk -v matrix="$1" -v shift="$2" 'BEGIN { split(matrix, a, " "); split(shift, b, " ") }
        $1 == "v" { $0 = sprintf("v %.17g %.17g %.17g", a[1] * $2 + a[2] * $3 + a[3] * $4 + b[1],
            a[4] * $2 + a[5] * $3 + a[6] * $4 + b[2], a[7] * $2 + a[8] * $3 + a[9] * $4 + b[3]) } { print }'
}
turned_over() { awk '$1 == "f" { face = "f " $2; for (k = NF; k > 2; --k) face = face " " $k; $0 = face } { print }'; }
# usage: with_mtl NAME
with_mtl() { sed "s/^mtllib .*/mtllib $1/"; }

slanted="1.1 0.2 -0.3  0.15 0.9 0.25  0.2 -0.1 1.3" shift="0.3 0.7 -1.7"
placed "$slanted" "$shift" <grid.obj >room.obj
placed "2 -1 2  2 2 -1  -1 2 2" "300.3 -50.7 20.1" <room.obj >turned.obj # and three times as large
placed "0 1 0  0 0 1  1 0 0" "0 0 0" <room.obj >exchanged.obj
placed "1 0 0  0 0 -1  0 1 0" "0 0 0" <room.obj >z_up.obj
placed "-1 0 0  0 1 0  0 0 1" "0 0 0" <room.obj | turned_over >mirrored.obj
placed "128 0 0  0 128 0  0 0 128" "0 0 0" <room.obj >large.obj
placed "100 0 0  0 100 0  0 0 100" "0 0 0" <room.obj >centimetres.obj
turned_over <room.obj >inside_out.obj
awk '/^o / { out = $2 == "box" } !out' room.obj >no_box.obj
awk '$1 == "f" { for (k = 2; k <= NF; ++k) { split($k, n, "/"); $k = n[1] - 24 (n[2] ? "/" n[2] - 5 : "") } } { print }' room.obj >backwards.obj
awk '$1 == "usemtl" { name = $2 } { text[name] = text[name] "\n" $0 } { names[name] }
    END { print text[""]; for (name in names) if (name != "") print text[name] }' room.obj >shuffled.obj
# The lamp in 40 pieces.
awk '/^f 9\/1/ { for (i = 0; i < 8; ++i) for (j = 0; j < 5; ++j) { k = 24 + 6 * i + j; print "f", k, k + 6, k + 7, k + 1 }; next }
    /^vt/ && !any { any = 1; for (i = 0; i <= 8; ++i) for (j = 0; j <= 5; ++j) print "v", 1 + i / 8, 2.2, 0.8 + 0.16 * j } { print }' \
    grid.obj | placed "$slanted" "$shift" >pieces.obj
# Surfaces with two sides: by an option, or as two faces.
awk '/^o backs/ { exit } { print }' room.obj >fronts.obj
{
    with_mtl plain.mtl <fronts.obj
    turned_over <fronts.obj | sed -n '/^f /p; s/^usemtl lamp/usemtl plain/p; /^usemtl/p'
} >doubled.obj
{ cat room.mtl; printf 'newmtl plain\nKd 0.1 0.15 0.1\n'; } >plain.mtl
# Light in other words.
sed '/^Ke/d' room.mtl >dark.mtl && with_mtl dark.mtl <room.obj >dark.obj
sed 's/^Ke .*/Ke 4096 3584 2560/' room.mtl >bright.mtl && with_mtl bright.mtl <room.obj >bright.obj
sed 's/^Kd 0.8 0.85 0.75/Kd 0.62 0.62 0.62/; s/^Kd 0.7 /Kd 0.62 /; s/^Kd 0.2 0.4 0.7/Kd 0.2 0.4 0.62/; s/^Kd 0.65/Kd 0.62/' room.mtl >limited.mtl
with_mtl limited.mtl <room.obj >limited.obj
# Textures: of many colours, with points as they are or transformed; and of one, whose values are decoded by IEC 61966-2-1.
awk 'BEGIN { print "P3 4 3 255"; for (k = 0; k < 36; ++k) print (97 * k * k + 31 * k) % 256 }' >many.ppm
echo "P3 2 1 255 200 100 50 200 100 50" >one.ppm
awk '{ print } $2 == "south" || $2 == "chest" { print "map_Kd many.ppm" } $2 == "board" { print "map_Kd -clamp on many.ppm" }
    $2 == "lamp" { print "map_Ke many.ppm" }' room.mtl >textured.mtl
sed 's/^map_K. /&-s 2 0.5 -o 0.25 -0.125 /' textured.mtl >mapped.mtl
with_mtl textured.mtl <room.obj >textured.obj && with_mtl mapped.mtl <room.obj >mapped.obj
awk '/^o / { out = $2 == "box" } !out' textured.obj >textured_no_box.obj
awk '$1 == "newmtl" { name = $2 } !/^(Ke|map_Ke) / || name != "lamp"' textured.mtl >unlit.mtl
with_mtl unlit.mtl <textured.obj >unlit.obj && turned_over <unlit.obj >unlit_over.obj
with_mtl dark.mtl <fronts.obj >single.obj && turned_over <single.obj >single_over.obj
awk '$1 == "f" && NF == 5 { print "f", $2, $3, $4; $3 = $4; $4 = $5; NF = 4 } { print }' textured.obj >triangles.obj
awk '$1 == "vt" { $2 = 2 * $2 + 0.25; $3 = 0.5 * $3 - 0.125 } { print }' textured.obj >transformed.obj
sed 's/many/one/' textured.mtl >one.mtl && with_mtl one.mtl <room.obj >one.obj
awk 'function linear(value) { return exp(2.4 * log((value / 255 + 0.055) / 1.055)) }
    $1 == "newmtl" { name = $2 }
    $1 == "Ke" || ($1 == "Kd" && (name == "south" || name == "chest" || name == "board")) {
        $0 = sprintf("%s %.17g %.17g %.17g", $1, $2 * linear(200), $3 * linear(100), $4 * linear(50)) } { print }' room.mtl >coloured.mtl
with_mtl coloured.mtl <room.obj >coloured.obj

rows() { grep -v '^#' "$1" | cut -d, -f1,2,4-; } # without the names of materials

# The values of two tables, the same to rounding. The factors are those of lengths and of light in the second.
# usage: near A.csv B.csv LENGTH LIGHT
near() {
    rows "$1" >first && rows "$2" | paste -d, first - | awk -F, -v length_factor="$3" -v light="$4" 'NR == 1 { next }
        { for (k = 3; k <= 18; ++k) { factor = k < 6 ? length_factor : k == 9 ? length_factor ^ 2 : k > 12 ? light : 1
              d = $(k + 18) - factor * $k; size = factor * ($k < 0 ? -$k : $k); if (d < 0) d = -d; if (d > 1e-9 * (size + factor) && !bad++) print "row " $1 ", column " k ":", $k, $(k + 18) } }
        END { print NR, "rows"; exit bad || NR < 100 || NF != 36 }'
}

# Mean radiosity by reflectance, and the area as a share of all: the same within the tolerance.
# usage: means A.csv B.csv TOLERANCE
means() {
    awk -F, -v tolerance="$3" 'FNR == 1 { ++file } !/^[0-9]/ { next }
        { key = sprintf("%.3g %.3g %.3g", $11, $12, $13); keys[key]; area[file, key] += $10; all[file] += $10
          for (k = 0; k < 3; ++k) { light[file, key, k] += $10 * $(17 + k); sum[file, k] += $10 * $(17 + k) } }
        function apart(what, a, b, limit) { d = a - b; if (d < 0) d = -d; if (d > limit) { print key ":", what, a, b; bad = 1 } if (limit && d / limit > worst) worst = d / limit }
        END { for (key in keys) { ++count; apart("area", area[1, key] / all[1], area[2, key] / all[2], 1e-9)
                  for (k = 0; k < 3; ++k) apart("light", light[1, key, k] / area[1, key], light[2, key, k] / area[2, key],
                      tolerance * (light[1, key, k] / area[1, key] + sum[1, k] / all[1]) / 2) }
              print count, "colours,", worst, "of the tolerance"; exit bad || count < 9 }' "$1" "$2"
}

# What a camera in the same place sees, by the sums over 4 x 3 parts of the picture, which a mirror exchanges.
# usage: looks A.pfm B.pfm TOLERANCE LIGHT MIRRORED
looks() {
    for picture in "$1" "$2"; do
        tail -c 14400 "$picture" | od -An -v -tf4 -w12 | awk -v mirrored="${picture#$1}:$5" '{ column = int((NR - 1) % 40 / 10); if (mirrored ~ /.:yes$/) column = 3 - column
            part = column + 4 * int((NR - 1) / 400); for (c = 1; c < 4; ++c) sum[part, c] += $c } END { for (part = 0; part < 12; ++part) print sum[part, 1], sum[part, 2], sum[part, 3] }'
    done | awk -v tolerance="$3" -v light="$4" '{ for (c = 1; c < 4; ++c) { if (NR <= 12) { part[NR, c] = $c; all += $c } else { d = $c / light - part[NR - 12, c]; if (d < 0) d = -d
            if (d > tolerance * (part[NR - 12, c] + all / 36) / 2) { print "picture, part", NR - 12 ":", part[NR - 12, c], $c / light; bad = 1 } } } } END { exit bad || NR != 24 || all == 0 }'
}

# Where the camera is in the scenes that are moved.
view() { awk '{ point[NR] = "[" $2 ", " $3 ", " $4 "]" } END { print "{\"eye\": " point[1] ", \"target\": " point[2] ", \"up\": " point[3] ", \"fov\": 70}" }'; }
for way in "room:1 0 0 0 1 0 0 0 1:0 0 0" "turned:2 -1 2 2 2 -1 -1 2 2:300.3 -50.7 20.1" "exchanged:0 1 0 0 0 1 1 0 0:0 0 0" \
    "mirrored:-1 0 0 0 1 0 0 0 1:0 0 0" "large:128 0 0 0 128 0 0 0 128:0 0 0"; do
    file=${way%%:*} way=${way#*:}
    {
        printf 'v 1.5 2 -0.5\nv 3 1.5 0.7\n' | placed "${way%:*}" "${way#*:}"
        echo "v 0.2 1 0.1" | placed "${way%:*}" "0 0 0"
    } | view >$file.json
done

# Where the power has gone, as a share of what is emitted.
# usage: powers TOLERANCE
powers() {
    for run in a b; do awk -F'[:,]' '/_power_w"/ { value[$1] = $2 } END { all = value["  \"emitted_power_w\""]; for (key in value) print key, value[key] / all }' $run.json | sort >$run.powers; done
    paste a.powers b.powers | awk -v tolerance="$1" '{ d = $2 - $4; if (d < 0) d = -d; if (d > tolerance) { print; bad = 1 } } END { exit bad || NR < 6 }'
}

# usage: pair HOW "SCENE OPTIONS" "SCENE OPTIONS"
# HOW: `bytes` of the rows; `near`, or `near:LENGTH:LIGHT` with these factors; or a tolerance for means. The pictures are
# compared, too, unless $pictures is `no`.
solved() {
    case $2 in *--patch-size*) ;; *) set -- "$1" "$2 --patch-size 0.7" ;; esac
    case $2 in *--lines*) ;; *) set -- "$1" "$2 --lines $lines" ;; esac
    camera=${2%%.obj*}.json
    [ -f "$camera" ] || camera=room.json
    seen=
    [ $pictures = no ] || seen="-o $1.pfm --size 40x30 --samples 1 --camera $camera"
    [ $how = bytes ] && seen="$seen -o $1.ply"
    ends 0 solve -q --json -o "$1.csv" $seen $2 && cp out "$1.json"
}
pair() {
    how=$1
    solved a "$2" && solved b "$3" || return
    mirrored=no
    case $3 in mirrored*) mirrored=yes ;; esac
    case $1 in
    bytes) rows a.csv >first && rows b.csv >second && cmp first second && [ "$(wc -l <first)" -gt 100 ] && cmp a.pfm b.pfm && same_mesh ;;
    near) near a.csv b.csv 1 1 && looks a.pfm b.pfm 1e-3 1 ;;
    near:*) factors=$(echo "$1" | sed 's/near//; s/:/ /g') && near a.csv b.csv $factors && looks a.pfm b.pfm 1e-3 "${1##*:}" ;;
    *) means a.csv b.csv "$1" && powers "$1" && { [ $pictures = no ] || looks a.pfm b.pfm "$(echo "$1" | awk '{ print 0.03 + 2 * $1 }')" 1 $mirrored; } ;;
    esac
}
same_mesh() { for mesh in a b; do sed '1,/^end_header/d' $mesh.ply >$mesh.body; done && [ -s a.body ] && cmp a.body b.body; }
lines=2^15 pictures=yes
# Of two faces back to back none has an inside, so the floor is cut along them as along partitions: the patches differ, and are small.
while IFS='|' read -r how sentence first second; do
    check "$sentence" pair $how "$first" "$second"
done <<'END'
bytes|a material emits by Ke or by --lamp                     |room.obj|dark.obj --lamp lamp=32,28,20
bytes|an object emits by Ke or by --lamp                      |room.obj|dark.obj --lamp lights=32,28,20
bytes|an object is ignored or not in the file                 |no_box.obj|room.obj --ignore box
bytes|so is one before textured faces                         |textured_no_box.obj|textured.obj --ignore box
bytes|--flip and faces in the other order                     |room.obj|inside_out.obj --flip
bytes|reflectances are limited by the option or in the file   |limited.obj|room.obj --reflectance-limit 0.62
bytes|faces count back or forth                               |room.obj|backwards.obj
bytes|texture points are transformed by the map or in the file|transformed.obj|mapped.obj
bytes|watts and lumens                                        |room.obj|room.obj --unit-light lux
near:1:128|128 times the light                                |room.obj|bright.obj
near:128:1|a large room has the light of a small one          |room.obj|large.obj --patch-size 89.6
0.01|turned, moved and three times as large                   |room.obj|turned.obj --patch-size 2.1
0.01|with axes exchanged                                      |room.obj|exchanged.obj
0.01|mirrored                                                 |room.obj|mirrored.obj
0.01|in triangles                                             |textured.obj|triangles.obj
0.01|a texture of one colour is that colour                   |coloured.obj|one.obj
0.01|in another order                                         |room.obj --ignore ceiling|shuffled.obj --ignore ceiling
0.01|a lamp in 40 pieces                                      |room.obj|pieces.obj
0.01|by surfaces with two sides or by two faces               |fronts.obj --two-sided --patch-size 0.1 --lines 2^19|doubled.obj --patch-size 0.1 --lines 2^19
0.02|with a table of pairs and without                        |room.obj --patch-size 0.3|room.obj --patch-size 0.3 --memory 9MB --lines 2^17
0.001|--unit and scaled coordinates                            |room.obj|centimetres.obj --unit cm
END

# Light from the sky that falls on backs counts like that on fronts, also for where patches are small.
turned_alike() {
    sky="--flip --ignore ceiling --two-sided --sky 3,2,1 --adaptive 1500" lines=2^17 pictures=no
    pair 0.05 "single.obj $sky" "single_over.obj $sky" || return
    for run in a b; do rows $run.csv | awk -F, '{ ++count[$2] } END { for (s = 0; s < 14; ++s) print count[s] }' >$run.counts; done
    paste a.counts b.counts | awk '{ d = $1 - $2; apart += d < 0 ? -d : d; all += $1 } END { print apart, "of", all, "patches elsewhere"; exit apart > 0.3 * all || all < 1000 }'
}
check "two sides that are exchanged" turned_alike

# No more patches than asked for, whatever the sides.
most_patches() {
    for most in "--patches 700" "--adaptive 700"; do for sides in "" --two-sided; do
        ends 0 solve room.obj -q $most $sides --lines 2^13 -o most.csv && count=$(grep -c '^[0-9]' most.csv) && [ $count -le 700 ] && [ $count -gt 350 ] || { echo "$most $sides: $count"; return 1; }
    done; done
}
check "--patches and --adaptive count both sides" most_patches

# The other methods, and other ways of the default one. Tolerances are about twice what the noise makes at this number of lines;
# global lines alone and gathering walks seldom meet the lamp.
lines=2^18 pictures=no
while IFS='|' read -r how options; do
    check "like the default: $options" pair $how "room.obj --ignore ceiling" "room.obj --ignore ceiling $options"
done <<'END'
0.02|--method local
0.04|--method local --estimator absorption --sequence random
0.07|--method global
0.10|--method global --bidirectional no --chords box
0.02|--method first-shot
0.02|--method extended
0.02|--method extended --threshold 0
0.02|--method jacobi
0.02|--method jacobi --bidirectional no
0.03|--method transillumination
0.05|--method gathering --lines 2^20
0.05|--method gathering --lines 2^20 --estimator absorption
0.01|--direct shoot
0.01|--sequence halton --chords sphere
0.01|--important board
0.01|--replicates 2
END

# What a state must keep, all at once.
outside="textured.obj --ignore ceiling --lamp floor=1,2,3 --sky 3,2,1 --sun 130,50,20,19,18 --unit-light lux --unit cm --two-sided"
outside="$outside --reflectance-limit 0.6 --adaptive 500 --lines 2^13 --state" view="-q --size 40x30 --samples 1 --camera room.json"
same_files() {
    for kind in csv pfm png glb ply obj html; do
        [ -s "$1.$kind" ] && cmp "$1.$kind" "$2.$kind" || return
    done
}
from_state() {
    outputs() { for kind in csv pfm png glb ply obj html; do echo "-o $1.$kind"; done; }
    ends 0 solve $outside whole.state $view $(outputs solved) && ends 0 render whole.state $view $(outputs again) && same_files solved again
}
check "all that a file and options say comes back from a state" from_state
in_shards() {
    ends 0 solve $outside first.state -q --shard 1/2 && ends 0 solve $outside second.state -q --shard 2/2 &&
        ends 0 merge first.state second.state $view -o merged.csv && rows merged.csv >first && rows solved.csv >second && cmp first second
}
check "and from shards" in_shards

# Sun and camera where z points up: the same picture. Pixels are rounded otherwise at edges.
upwards() {
    light="-q --ignore ceiling --patch-size 0.7 --lines 2^18 --size 40x30 --samples 4 --fov 65"
    ends 0 solve room.obj $light --sun 130,50,20 --eye 1.5,3,1 --target 3,1,-0.2 -o y.pfm -o y.csv &&
        ends 0 solve z_up.obj $light --sun 130,50,20 --up 0,0,1 --eye 1.5,-1,3 --target 3,0.2,1 -o z.pfm -o z.csv && means y.csv z.csv 0.01 || return
    for axis in y z; do # sums over 4 x 3 parts
        tail -c 14400 $axis.pfm | od -An -v -tf4 -w12 | awk '{ part = int((NR - 1) % 40 / 10) + 4 * int((NR - 1) / 400); sum[part] += $1 + 2 * $2 + 4 * $3 }
            END { for (k = 0; k < 12; ++k) print sum[k] }' >$axis.parts
    done
    paste y.parts z.parts | awk '{ d = $1 / $2 - 1; if (d * d > 0.0001) { print; bad = 1 } sum += $1 } END { exit bad || NR != 12 || sum == 0 }'
}
check "--up turns camera and sun with the scene" upwards

# Colours of vertices: of 1600 faces as many, or as many materials.
awk 'function linear(value) { return value <= 0.04045 ? value / 12.92 : exp(2.4 * log((value + 0.055) / 1.055)) }
    BEGIN {
        print "mtllib sides.mtl\nv -1 0.6 -1\nv -1 0.6 4\nv 5 0.6 4\nusemtl sides\nf 3 2 1" >"vertices.obj"
        print "mtllib faces.mtl\nv -1 0.6 -1\nv -1 0.6 4\nv 5 0.6 4\nusemtl sides\nf 3 2 1" >"faces.obj"
        print "newmtl sides\nKd 0.2 0.3 0.4\nKe 3 2 1\nnewmtl white\nKd 1 1 1" >"sides.mtl"
        print "newmtl sides\nKd 0.2 0.3 0.4\nKe 3 2 1" >"faces.mtl"
        for (k = 0; k < 1600; ++k) {
            r = (50 + k % 200) / 255; g = (40 + int(k / 10)) / 255; b = (250 - k % 130) / 255; x = k % 40 * 0.1; z = int(k / 40) * 0.07
            for (c = 0; c < 4; ++c) { corner = sprintf("v %.17g %.17g %.17g", x + (c > 1) * 0.1, 0.03 * x + 0.01 * c, z + (c == 1 || c == 2) * 0.07)
                printf "%s %.17g %.17g %.17g\n", corner, r, g, b >"vertices.obj"; print corner >"faces.obj" }
            print (k ? "" : "usemtl white\n") "f -4 -3 -2 -1" >"vertices.obj"
            print "usemtl m" k "\nf -4 -3 -2 -1" >"faces.obj"
            printf "newmtl m%d\nKd %.17g %.17g %.17g\n", k, linear(r), linear(g), linear(b) >"faces.mtl"
        } }'
sed 's/sides.mtl/plain_sides.mtl/' vertices.obj >white.obj && sed '/^Kd 1 1 1/d' sides.mtl >plain_sides.mtl
vertex_colours() {
    of_faces() { ends 0 solve $1.obj -q --method local --patch-size 9 --lines 2^12 $2 -o $1.csv && rows $1.csv >$1.rows; }
    of_faces vertices "--reflectance-limit 0.7" && of_faces white "--reflectance-limit 0.7" && cmp vertices.rows white.rows || return
    of_faces vertices && of_faces faces && paste -d, vertices.rows faces.rows | awk -F, '
        { for (k = 10; k < 13; ++k) { d = $k - $(k + 18); if (NR > 1 && d * d > 1e-8) { print NR, k, $k, $(k + 18); exit bad = 1 } } } END { exit bad || NR < 1600 }'
}
check "colours of vertices are those of materials, and a material without Kd is white" vertex_colours

# Light is linear: what lamps, sky and sun bring alone adds up to what they bring together, in whatever shows it. Faces are
# turned over here and by --flip, so that no side depends on the light.
turned_over <textured.obj >lamps.obj && cp unlit_over.obj sky.obj && cp unlit_over.obj sun.obj && cp lamps.obj all.obj
sky="--sky 3,2,1" sun="--sun 130,50,40,30,20"
# usage: lit NAME OPTIONS...     what the scene NAME.obj shows: NAME.csv, NAME-grid.csv, NAME-smooth.pfm ...
lit() {
    name=$1
    shift
    look="-q --size 40x30 --samples 4 --camera room.json"
    ends 0 solve $name.obj -q --flip --ignore ceiling --two-sided --patch-size 0.5 --lines 2^16 "$@" --json -o $name.csv -o $name.state && cp out $name.json &&
        ends 0 render $name.state -q --grid 0.9,0.45 -o $name-grid.csv && ends 0 render $name.state $look -o $name-smooth.pfm &&
        ends 0 render $name.state $look --shading gather -o $name-gather.pfm && ends 0 render $name.state $look --show direct --shading gather -o $name-direct.pfm
}
# Four files side by side: rows of `key red green blue`, whose sums over each key are compared.
# usage: adds_up WHAT TOLERANCE KEYS
adds_up() {
    paste lamps.rows sky.rows sun.rows all.rows | awk -v what="$1" -v tolerance="$2" -v least="$3" 'NF != 16 || $1 != $13 { print what, "row", NR ":", $0; exit bad = 1 }
        { keys[$1]; for (c = 2; c < 5; ++c) { sum[$1, c] += $c + $(c + 4) + $(c + 8); all[$1, c] += $(c + 12); whole[c] += $(c + 12) } }
        END { for (key in keys) ++count
              for (key in keys) for (c = 2; c < 5; ++c) { d = sum[key, c] - all[key, c]; if (d < 0) d = -d; size = (all[key, c] + whole[c] / count) / 2
                  if (d > worst * size) worst = d / size; if (d > tolerance * size) { print what, key, c, sum[key, c], all[key, c]; bad = 1 } }
              print what ":", count, "keys,", worst; exit bad || count < least }'
}
superposed() {
    lit lamps && lit sky $sky && lit sun $sun && lit all $sky $sun || return
    for name in lamps sky sun all; do rows $name.csv | awk -F, 'NR > 1 && $9 > 0 { print $2 ($6 * $7 + $8 > 0), $9 * $16, $9 * $17, $9 * $18 }' >$name.rows; done
    adds_up tables 0.02 18 || return
    for name in lamps sky sun all; do awk -F, '/^[-0-9]/ { print int(n / 10), $4, $5, $6; ++n }' $name-grid.csv >$name.rows; done
    adds_up grids 0.01 6 || return
    for how in smooth:0.06 gather:0.015 direct:0.01; do
        tolerance=${how#*:} how=${how%:*}
        for name in lamps sky sun all; do
            tail -c 14400 $name-$how.pfm | od -An -v -tf4 -w12 | awk '{ print int((NR - 1) % 40 / 10) + 4 * int((NR - 1) / 400), $1, $2, $3 }' >$name.rows
        done
        adds_up $how $tolerance 12 || return
    done
}
check "lamps, sky and sun add up, in tables, grids and pictures" superposed

# What a report says of a scene and its light is what the table of the same run adds up to.
# usage: numbers JSON KEY...      the numbers of these keys, in one line
numbers() { tr -d '",[]' <"$1" | awk -v keys="$2" 'BEGIN { n = split(keys, key, " ") } { name = $1; sub(/:$/, "", name); $1 = ""; if (!(name in text)) text[name] = $0 } END { for (k = 1; k <= n; ++k) printf "%s", text[key[k]]; print "" }'; }
# usage: same_numbers WHAT      compares the lines of `told` and `added`
same_numbers() {
    paste told added | awk -v what="$1" '{ for (k = 1; k <= NF / 2; ++k) { d = $k - $(k + NF / 2); if (d < 0) d = -d; if (!(d <= 1e-9 * ($k < 0 ? -$k : $k))) { print what ", number " k ":", $k, $(k + NF / 2); bad = 1 } } }
        END { exit bad || NF < 4 || NF % 2 }'
}
totals() { # of a table without comments
    awk -F, 'NR == 1 { next } { if (++n && $9 > 0 && $2 >= surfaces) surfaces = $2 + 1; a = $9; area += a; rho += a * ($10 + $11 + $12) / 3
            for (c = 0; c < 3; ++c) { r[c] += a * $(10 + c); e[c] += a * $(13 + c); b[c] += a * $(16 + c) } }
        END { printf "%d %d %.17g %.17g", n, surfaces, area, rho / area
              for (c = 0; c < 3; ++c) printf " %.17g", b[c] / area
              for (c = 0; c < 3; ++c) printf " %.17g", e[c]
              for (c = 0; c < 3; ++c) printf " %.17g", r[c] / area; print "" }'
}
reported() {
    of_run="patches surfaces area_m2 average_reflectance mean_radiosity_rgb"
    numbers all.json "$of_run" >told && rows all.csv | totals | cut -d' ' -f1-7 >added && same_numbers "solve, sky and sun" || return
    numbers lamps.json "$of_run source_power_rgb_w" >told && rows lamps.csv | totals | cut -d' ' -f1-10 >added && same_numbers "solve, lamps" || return
    "$program" check textured.obj --ignore ceiling --json --two-sided --patch-size 0.7 --lines 1000 >check.json
    ends 0 solve textured.obj -q --ignore ceiling --two-sided --patch-size 0.7 --lines 1000 -o check.csv && rows check.csv | totals >sums || return
    numbers check.json "patches surfaces area_m2 average_reflectance source_power_rgb_w average_reflectance_rgb" >told
    cut -d' ' -f1-4,8- sums >added && same_numbers check || return
    # In words the same numbers with fewer digits.
    "$program" check textured.obj --ignore ceiling --two-sided --patch-size 0.7 --lines 1000 >check.txt
    numbers check.json "bounds_low bounds_high area_m2 patches box_area_m2 average_reflectance source_power_w source_power_rgb_w intersections intersections_measured lit_fraction secondary_reflectance ratio_first_shot ratio_extended threshold_radiosity escaped_share back_face_share" | awk '{
        printf "size: %.5g x %.5g x %.5g m from (%.5g, %.5g, %.5g) to (%.5g, %.5g, %.5g)\n", $4 - $1, $5 - $2, $6 - $3, $1, $2, $3, $4, $5, $6
        printf "area: %.6g m^2 in %d patches of at most 0.7; bounding box %.6g m^2\n", $7, $8, $9
        printf "reflectance          %.4f\nsources      %.6g W (%.4g, %.4g, %.4g)\n", $10, $11, $12, $13, $14
        printf "lamp                 %.5g W (%.4g, %.4g, %.4g) from ", $11, $12, $13, $14
        printf "\na line       %.4f (measured %.4f)\n", $15, $16
        printf "lit     %.4f visible\nlit area   %.4f\n%.4f first shot, %.4f extended\n%.6g W/m^2\n%.4g %% escapes, %.4g %% is lost\n", $17, $18, $19, $20, $21, 100 * $22, 100 * $23 }' >words
    grep '^[0-9]' check.csv | awk -F, '{ area[$3] += $10; for (c = 0; c < 3; ++c) r[$3, c] += $10 * $(11 + c) }
        END { for (m in area) printf "%-20s reflectance %-26s %10.4g m^2\n", m, sprintf("(%.4g, %.4g, %.4g)", r[m, 0] / area[m], r[m, 1] / area[m], r[m, 2] / area[m]), area[m] / 2 }' >>words
    [ "$(wc -l <words)" -gt 18 ] && while read -r words; do says check.txt "$words" || return; done <words
}
check "reports say what tables add up to, in words and in JSON" reported
finish
