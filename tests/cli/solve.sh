# The main job as a user runs it: a scene in, pictures, a table and a summary out.
. "$2/tests/cli/check.sh"
scene=$root/scenes/5cubes.obj
small="--size 80x60 --samples 1 --patch-size"
quick="--lines 20000 $small 0.4"

default_outputs() {
    ends 0 solve "$scene" $quick && silent out && says err "absorbed" && says err "lines/s" &&
        [ "$(head -c 2 5cubes.ppm)" = P6 ] && [ "$(head -c 4 5cubes.png | tail -c 3)" = PNG ]
}
check "without -o a scene gives a PPM and a PNG of its name in the working folder" default_outputs

not_black() { tail -c 14400 5cubes.ppm | od -An -v -tu1 | awk '{for (i = 1; i <= NF; ++i) s += $i} END {exit s / 14400 < 40}'; }
check "the picture is not black" not_black

same_bytes() {
    for run in 1 2; do
        for threads in 1 2; do
            ends 0 solve "$scene" $quick --threads $threads -o $run-$threads.png -o $run-$threads.csv -o $run-$threads.ppm ||
                return
        done
    done
    for kind in png csv ppm; do
        cmp 1-1.$kind 1-2.$kind && cmp 1-1.$kind 2-1.$kind && cmp 1-1.$kind 2-2.$kind || return
    done
}
check "one and two threads give the same bytes, run after run" same_bytes

table() {
    ends 0 solve "$scene" --lines 20000 $small 1 -o room.csv || return
    grep -q '^# command: multipath solve .*5cubes.obj.* --lines 20000' room.csv && grep -q '^# seed: 1$' room.csv &&
        grep -Eq '^# scene: [0-9a-f]{16}$' room.csv || { head -5 room.csv; return 1; }
    # 6 walls of 3 x 3 patches, 5 cubes of 6 and a lamp of 6; areas add up to the scene's 70.3446 m^2
    grep -v '^#' room.csv | awk -F, 'NR == 1 { if (NF != 19 || $19 != "radiosity_b") exit 1; next }
        { if (NF != 19 || $17 < 0) exit 1; area += $10 } END { exit !(NR == 91 && area > 70.34463 && area < 70.34465) }'
}
check "the table says where it comes from and has a row per patch" table

summary() {
    ends 0 solve "$scene" $quick --json --quiet -o room.csv && silent err || return
    for key in scene patches surfaces area_m2 average_reflectance source_power_w method sequence lines local_lines \
        global_lines mean_radiosity unshot_power_w escaped_power_w back_face_power_w balance_error seconds \
        seconds_trace seconds_outputs seconds_to_first_lines lines_per_second threads relative_standard_error; do
        says out "\"$key\": " || return
    done
    says out '"lines": 20000' && says out '"escaped_power_w": 0,' && says out '"sequence": "sobol"'
}
check "--json prints a summary with the promised keys" summary

piped() { "$program" solve "$scene" $quick -o - 2>err | head -c 2 | grep -q P6; }
check "-o - writes a PPM to standard output" piped

reader_gone() { "$program" solve "$scene" $quick --quiet -o - 2>err | head -c 100 >/dev/null; [ "$(wc -l <err)" -le 1 ]; }
check "a reader that leaves early costs at most one line" reader_gone

not_the_input() {
    cp "$scene" copy.csv && ends 2 solve copy.csv $quick -o ./copy.csv && says err "is an input" && cmp "$scene" copy.csv
}
check "an output never replaces the input" not_the_input

not_the_materials() {
    cp "$scene" room.obj && cp "$root/scenes/5cubes.mtl" 5cubes.mtl && ln -sf 5cubes.mtl link.png &&
        ends 2 solve room.obj $quick -o link.png && says err "is an input" && cmp 5cubes.mtl "$root/scenes/5cubes.mtl"
}
check "nor the materials, through whatever name" not_the_materials

idle_lamp() {
    printf 'mtllib idle.mtl\nusemtl lamp\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >alone.obj
    printf 'newmtl lamp\nKd 0.5 0.5 0.5\nKe 1 1 1\nnewmtl wall\nKd 0.5\n' >idle.mtl
    { cat alone.obj && printf 'usemtl wall\nv 0 0 -1\nv 1 0 -1\nv 0 1 -1\nf 4 5 6\n'; } >idle.obj
    for method in reuse extended; do
        ends 1 solve idle.obj $quick --method $method -o idle.png && says err "no light reaches" && [ ! -e idle.png ] &&
            ends 0 solve alone.obj $quick --method $method -o alone.png -o alone.csv || return
    done
}
check "light that reaches nothing is no picture, but a lamp alone is one" idle_lamp

# In millimetres, white as the sky, and without a lamp: the options of the error mend all of it.
units_and_white() {
    sed 's/^Kd .*/Kd 1 1 1.2/; /^Ke/d' "${scene%.obj}.mtl" >white.mtl && sed "s/^mtllib .*/mtllib white.mtl/" "$scene" >white.obj || return
    ends 1 solve white.obj --unit mm $quick && says err "is above 1" && says err "no emitter" || return
    options="--unit mm $(sed -n 's/.*: \(--reflectance-limit .*\)$/\1/p' err)"
    says err ": --reflectance-limit 0.9 --lamp lamp=10" && ends 0 solve white.obj $options $quick -o white.csv &&
        says white.csv " --unit mm" && says white.csv " --reflectance-limit 0.9" &&
        ends 0 solve "$scene" $quick -o m.csv && ends 0 solve "$scene" $quick --unit cm -o cm.csv &&
        awk -F, '/^[0-9]/ { area[FILENAME] += $10; sum[FILENAME] += $10 * $17 }
            END { r = area["m.csv"] / area["cm.csv"] / 1e4; b = sum["m.csv"] / sum["cm.csv"] / 1e4
                  exit r < 0.999999 || r > 1.000001 || b < 0.99 || b > 1.01 }' m.csv cm.csv &&
        ends 2 solve "$scene" --unit ell && says err "--unit: expected one of" &&
        ends 2 solve "$scene" --reflectance-limit 1.5 && says err "--reflectance-limit"
}
check "coordinates have a unit, and reflectances a limit" units_and_white

# A cube as a modeller makes it: all faces look outward, and its top is the lamp; and one without a floor.
inside_out() {
    printf '%s\n' 'mtllib cube.mtl' 'v 0 0 0' 'v 2 0 0' 'v 2 0 2' 'v 0 0 2' 'v 0 2 0' 'v 2 2 0' 'v 2 2 2' 'v 0 2 2' \
        'usemtl wall' 'f 1 5 6 2' 'f 3 7 8 4' 'f 4 8 5 1' 'f 2 6 7 3' 'usemtl lamp' 'f 5 8 7 6' >outward.obj
    printf '%s\n' 'newmtl wall' 'Kd 0.5' 'newmtl lamp' 'Kd 0.5' 'Ke 1' >cube.mtl
    for method in reuse extended local; do
        ends 1 solve outward.obj --lines 4096 --method $method --quiet -o a.csv && says err "emitters face away" || return
    done
    ends 0 solve outward.obj --lines 4096 --flip -o a.csv && says a.csv " --flip" &&
        ends 1 check outward.obj --lines 5000 && says out "--flip" && [ "$(grep -c WRONG out)" = 1 ] &&
        ends 0 study outward.obj --flip --methods extended --sequences random --from 1000 --to 2000 -o s.csv --quiet &&
        ends 0 explain outward.obj --flip -o e.svg || return
    { cat outward.obj && printf '%s\n' 'usemtl wall' 'f 1 2 3 4'; } >closed.obj
    ends 0 solve closed.obj --lines 4096 -o a.csv && says err "away from the light were turned over: 6 " && says err "0.00 % escaped" &&
        ends 0 solve closed.obj --lines 4096 --flip -o b.csv && ! grep -q "turned over" err && same_patches a.csv b.csv &&
        ends 0 check closed.obj --lines 5000 && says out "turned over" && ! grep -q WRONG out &&
        ends 0 solve closed.obj --lines 4096 --two-sided -o a.csv && says err "0.00 % escaped"
}
same_patches() { grep -v '^#' "$1" >one && grep -v '^#' "$2" >two && cmp -s one two; }
check "--flip lights a room that was modelled inside out, and is named where it helps; closed walls turn without it" inside_out

# A sheet in the sun or below a lamp, either side up: E cos / 2 in the sun. An option of the user is not overridden.
lit_from_behind() {
    for order in '1 2 3 4' '4 3 2 1'; do
        printf '%s\n' 'mtllib cube.mtl' 'v 0 0 0' 'v 0 0 2' 'v 2 0 2' 'v 2 0 0' 'usemtl wall' "f $order" >"sheet ${order% *}.obj"
    done
    { cat 'sheet 4 3 2.obj' && printf '%s\n' 'v 0 1 0' 'v 2 1 0' 'v 2 1 2' 'v 0 1 2' 'usemtl lamp' 'f 5 6 7 8'; } >below.obj
    turned="away from the light were turned over: 1 (--flip turns all faces instead, --two-sided gives them backs)"
    for sheet in 'sheet 1 2 3.obj' 'sheet 4 3 2.obj'; do
        ends 0 solve "$sheet" --sun 30,30,10 --lines 4096 --patches 4 -o "$sheet.csv" &&
            awk -F, '/^[0-9]/ { n += $17 < 2.4999 || $17 > 2.5001 } END { exit n > 0 }' "$sheet.csv" || return
    done
    says err "$turned" && ends 0 check 'sheet 4 3 2.obj' --sun 30,30,10 --lines 1000 && says out "$turned" && ! grep -q WRONG out &&
        ends 0 solve 'sheet 1 2 3.obj' --sun 30,30,10 --lines 4096 -o a.csv && ! grep -q "turned over" err &&
        ends 0 solve below.obj --lines 4096 -o a.csv && says err "$turned" &&
        ends 0 solve below.obj --lines 4096 -o a.csv --two-sided && ! grep -q "turned over" err || return
    for command in solve check; do
        ends 1 $command 'sheet 1 2 3.obj' --sun 30,30,10 --flip && says err "the sun shines on no front" && ! grep -q -e --flip err out &&
            ends 1 $command below.obj --flip && ! grep -q -e --flip err out || return
    done
}
# It absorbs nothing, yet is lit: its radiosity is that of the sky.
white_sheet() {
    sed 's/^Kd 0.5/Kd 1/' cube.mtl >white.mtl && sed 's/cube.mtl/white.mtl/' 'sheet 1 2 3.obj' >white.obj &&
        ends 0 solve white.obj --sky 1 --lines 4096 -o a.csv &&
        awk -F, '/^[0-9]/ && $3 == "wall" { ++n; wrong += $17 < 1 - 1e-9 || $17 > 1 + 1e-9 } END { exit n == 0 || wrong > 0 }' a.csv
}
check "what light meets only from behind is turned over, unless --flip or --two-sided is given" lit_from_behind
check "a white sheet under the sky is not taken for dark" white_sheet

# A house with walls 0.3 m thick, its lamp inside, under the sky: the outer side of each wall has the radiosity E / 2.
thick_walls() {
    awk 'function shell(low, high, faces, i) {
            for (i = 0; i < 8; ++i) print "v", (i % 2 ? high : low), (i % 4 > 1 ? high : low), (i > 3 ? high : low)
            split(faces, f, ";"); for (i = 1; i <= 6; ++i) print "f", f[i] }
        BEGIN { out = "-8 -6 -5 -7;-4 -3 -1 -2;-8 -7 -3 -4;-6 -2 -1 -5;-8 -4 -2 -6;-7 -5 -1 -3"
                inward = "-7 -5 -6 -8;-2 -1 -3 -4;-4 -3 -7 -8;-5 -1 -2 -6;-6 -2 -4 -8;-3 -1 -5 -7"
                print "mtllib cube.mtl\nusemtl wall"; shell(0, 3, inward); shell(-0.3, 3.3, out)
                print "usemtl lamp\nv 1 2.5 1\nv 2 2.5 1\nv 2 2.5 2\nv 1 2.5 2\nf -4 -3 -2 -1" }' >house.obj
    ends 0 solve house.obj --sky 10 --lines 2^14 --patches 300 -o a.csv && ! grep -q "turned over" err &&
        awk -F, '/^[0-9]/ && $3 == "wall" && ($4 < -0.2 || $4 > 3.2) { ++n; wrong += $17 < 4.9 || $17 > 5.1 } END { exit n == 0 || wrong > 0 }' a.csv
}
check "the outer walls of a lit house look outwards, where the sky shines on them" thick_walls

without_effect() { ends 2 solve "$scene" --method local --ratio 2 && says err "no effect" && ends 2 solve "$scene" --json -o - && says err "standard output"; }
check "options that would do nothing or collide are refused" without_effect

twice() { ends 2 solve "$scene" $quick -o new.png -o ./new.png && says err "twice" && ends 2 solve "$scene" $quick -o new.png -o new.png; }
check "an output named twice is refused" twice

# The lamp of the file taken out, and put back by an option: the same results, lines and all.
lamps() {
    sed 's/^Ke .*//' "$root/scenes/5cubes.mtl" >5cubes.mtl && cp "$scene" dark5.obj &&
        ends 1 solve dark5.obj $quick && says err "no emitter" && lines_are err 1 || return
    options=$(sed -n 's/.*: \(--lamp [^ ]*\)$/\1/p' err)
    ends 0 solve dark5.obj $quick $options -o first.csv || return # what the error says
    ends 0 solve dark5.obj $quick --lamp lamp=27,25,23 -q -o lit.csv && ends 0 solve "$scene" $quick -q -o file.csv || return
    grep -v '^#' lit.csv >lit && grep -v '^#' file.csv >file && cmp lit file && grep -q "^# command: .* --lamp lamp=27,25,23 " lit.csv &&
        ends 0 solve "$scene" $quick -q --ignore cube_middle -o less.csv && [ "$(wc -l <less.csv)" -lt "$(wc -l <file.csv)" ] &&
        ends 2 solve "$scene" $quick --lamp nothing=1 && says err "no material or object is called" &&
        ends 2 solve "$scene" $quick --lamp lamp=1 --lamp lamp=2,2,2 && says err "--lamp: 'lamp' is named twice" &&
        ends 2 solve "$scene" $quick --ignore lamp --ignore lamp && says err "--ignore: 'lamp' is named twice" &&
        ends 2 solve "$scene" $quick --lamp lamp && says err "expected a name and a power" &&
        ends 2 solve "$scene" $quick --lamp lamp=1,-1,0 && says err "from 0 to 1e30" &&
        ends 2 solve "$scene" $quick --lamp lamp=0,0,0 && says err "above 1e-30"
}
check "a file without lamps is lit by the option that its error names, and faces are left out by name" lamps

# An open box from outside: a file whose error names sky and sun.
daylight() {
    printf 'v 0 0 0\nv 4 0 0\nv 4 0 4\nv 0 0 4\nv 1 0 1\nv 2 0 1\nv 2 0 2\nv 1 0 2\nv 1 1 1\nv 2 1 1\nv 2 1 2\nv 1 1 2\n' >open.obj
    printf 'f 1 4 3 2\nf 9 12 11 10\nf 5 9 10 6\nf 6 10 11 7\nf 7 11 12 8\nf 8 12 9 5\nf 5 6 7 8\n' >>open.obj
    ends 1 solve open.obj $quick && says err "no emitter" && says err ": --lamp default=10" &&
        ends 0 solve open.obj $quick --sky 10 --sun 150,40,20 -o day.csv -o day.png -o day.glb --state day.state --json -o day.obj || return
    [ "$(grep -c ',sky,' day.csv)" = 6 ] && ! grep ',sky,' day.csv | cut -d, -f10 | grep -qv '^0$' && ! grep -q '"name": *"sky' day.glb && ! grep -q 'usemtl sky' day.obj &&
        [ "$(sed -n 's/.*"area_m2": //p' out)" = "22," ] && ends 0 compare day.csv day.state && says out "relative 0, its root 0" &&
        ends 0 render day.state --size 40x30 -q -o again.png && ends 0 check open.obj --sky 10 --sun 0,90,1 && says out "the sun" &&
        ends 0 check "$scene" --sky 1 || return
    for bad in 1,2 a,40,20 1,91,5 1,-1,5 1,40,0 1,40,1,2; do ends 2 solve open.obj --sun $bad && says err "--sun" || return; done
    for bad in 0 -1 x 1,2 0,0,0; do ends 2 solve open.obj --sky $bad && says err "--sky" || return; done
    ends 0 solve open.obj $quick --sky 1 --sun 90,20,3 -q --shard 1/2 --state s1.state &&
        ends 0 solve open.obj $quick --sky 1 --sun 90,20,3 -q --shard 2/2 --state s2.state &&
        ends 0 merge s1.state s2.state -q -o merged.csv && ends 0 solve open.obj $quick --sky 1 --sun 90,20,3 -q -o whole.csv &&
        same_patches merged.csv whole.csv
}
check "sky and sun light what has no lamps; they are kept with states and left out of results" daylight

# A room whose floor has a picture of its own: kept with the state, in the mesh, and told where it cannot be read.
textures() {
    printf 'P3 2 2 255\n255 255 255 20 20 20\n20 20 20 255 255 255\n' >checks.ppm
    sed 's/^newmtl white.*/&\nmap_Kd checks.ppm/' "$root/scenes/cornell.mtl" >cornell.mtl
    { printf 'vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n'; sed 's/^\(f [0-9-]*\) \([0-9-]*\) \([0-9-]*\) \([0-9-]*\)$/\1\/1 \2\/2 \3\/3 \4\/4/' "$root/scenes/cornell.obj"; } >floor.obj
    ends 0 solve floor.obj $quick -o t.csv -o t.png -o t.glb --state t.state && ! says err "not read" || return
    ends 0 solve floor.obj --patches 300 --lines 1000 -q -o fine.csv && # a reflectance for each patch
        [ "$(grep ',white,' fine.csv | cut -d, -f11 | sort -u | wc -l)" -gt 8 ] && grep -q '"baseColorTexture"' t.glb && rm checks.ppm &&
        ends 0 render t.state --size 80x60 --samples 1 -o again.ppm -o again.glb -q && cmp t.glb again.glb &&
        ends 0 compare t.csv t.state && says out "relative 0, its root 0" &&
        ends 0 solve floor.obj $quick -o plain.csv && says err "1 texture not read" && says err "(checks.ppm: not found)"
}
check "textures colour patches, pictures and meshes, and are kept with states" textures

photometry() {
    ends 0 solve "$root/scenes/cornell.obj" $quick --unit-light lux --grid 0.1,0.1 -o grid.csv -o lux.png --show irradiance --state lux.state &&
        says err " lx on average, least " && says err "emitted 1.06167 lm" && grep -q "^# unit: lx" grid.csv &&
        grep -q "^# grid: .* uniformity 0\." grid.csv && grep -q "^x,y,z,irradiance_r" grid.csv && [ "$(grep -c '^[0-9-]' grid.csv)" -gt 20 ] &&
        ends 0 render lux.state --grid 0.1,0.1 -q -o again.csv && same_patches grid.csv again.csv || return
    # In a furnace every point receives what every surface sends.
    ends 0 solve "$root/scenes/furnace.obj" --lines 2^17 --grid 0.3,0.3 -o furnace.csv && says err "grid       2 W/m^2 on average, least 2, most 2, uniformity 1.000" || return
    for bad in 1 1,0 x,1 1,-2; do ends 2 solve "$root/scenes/cornell.obj" --grid $bad -o g.csv && says err "--grid" || return; done
    ends 2 solve "$root/scenes/cornell.obj" $quick --grid 50,0.1 -o g.csv && says err "no point lies above" && [ ! -e g.csv ]
}
check "with lamps in lm/m^2 results are in lux, on a horizontal grid, too" photometry

lightmaps() {
    ends 0 solve "$root/scenes/cornell.obj" $quick -q -o c_lightmap.glb && [ "$(head -c 4 c_lightmap.glb)" = glTF ]
}
check "a lightmap is one file" lightmaps

# Rays of the sky from below meet the floor, not the bottom of what stands on it.
all_agree() {
    for method in local global extended jacobi transillumination gathering reuse; do
        ends 0 solve open.obj --patch-size 2 --lines 2^20 --sky 10 --two-sided --method $method -q -o $method.csv || return
    done
    for method in local global extended jacobi transillumination gathering; do
        ends 0 compare $method.csv reuse.csv --json && relative=$(sed -n 's/.*"relative_mean_square_error": \([^,]*\).*/\1/p' out) &&
            awk "BEGIN { exit !($relative < 1e-4) }" || return
    done
}
check "the methods agree under a sky" all_agree

# Four triangles in a plane, lit from both sides, and a fifth that leans over it: rays between patches are few and grazing,
# and no exchange by these rays alone fills the areas. The numbers are two heights for each of the four, and how far the
# fifth leans.
grazing() {
    printf 'newmtl wall\nKd .75 .75 .7\nnewmtl pane\nKd 0\nKe 20\n' >grazing.mtl
    for shape in '.11 1.78 .01 1.51 -.06 2 -.13 1.15 .3' '-.14 1.69 .11 1.85 -.19 1.23 -.21 1.23 .75'; do
        echo "$shape" | awk 'function face(a, b, c) { print "v", a; print "v", b; print "v", c; print "f -3 -2 -1" }
            { print "mtllib grazing.mtl\nusemtl wall"
              for (k = 0; k < 4; ++k) face("0 " k " 0", "0 " k + 1 " " $(2 * k + 1), "0 " k + .5 " " $(2 * k + 2))
              face("0 4.2 .2", -$9 " 4.3 0", "0 4.4 .1"); print "usemtl pane"
              face("-.2 2 7", "-.2 2.2 7.2", "-.2 1 7.2"); face("-.2 0 5.5", "-.2 .3 5.6", "-.2 0 7") }' >grazing.obj
        for method in local reuse; do
            ends 0 solve grazing.obj --two-sided --method $method -o $method.csv && ! grep particles err &&
                sed -n 's/^radiosity  mean \([^ ]*\) .*/\1/p' err >$method.mean || return
        done
        paste local.mean reuse.mean | awk '{ print; exit !($2 > 0.999 * $1 && $2 < 1.001 * $1) }' || return
    done
}
check "surfaces that see little of each other reflect no more light than arrives" grazing

old_file_kept() {
    echo old >kept.csv && ends 1 solve missing.obj $quick -o kept.csv && grep -q old kept.csv && [ -z "$(find . -name '.*part*')" ]
}
check "when the scene cannot be read, an old result stays and nothing is left behind" old_file_kept

dark() {
    printf 'mtllib dark.mtl\nusemtl wall\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >dark.obj
    printf 'newmtl wall\nKd 0.5 0.5 0.5\n' >dark.mtl
    ends 1 solve dark.obj $quick && says err "no emitter" && [ ! -e dark.png ]
}
check "a scene without light is refused and leaves no black picture" dark

broken() {
    printf 'v 0 0 0\nv 1 0 zero\n' >broken.obj
    ends 1 solve broken.obj $quick && lines_are err 1 && says err "broken.obj:2: "
}
check "a broken scene is one line that names the place" broken

# All walls of the furnace have 2 W/m^2 (scenes/furnace.obj). 1944 patches make two million pairs, more than fit.
without_pairs() {
    ends 0 solve "$root/scenes/furnace.obj" --patches 2000 --lines 2^15 --memory 11MB --direct shoot -q -o furnace.csv &&
        awk -F, '/^[0-9]/ { ++n; for (k = 17; k <= 19; ++k) wrong += $k < 1.99999 || $k > 2.00001 }
            END { exit !(n == 1944 && wrong == 0) }' furnace.csv
}
check "reuse without memory for pairs finds the light of a furnace after a first shot" without_pairs

huge() { ends 2 solve "$scene" --lines 1000 --patch-size 1e-6 --memory 100000TB && lines_are err 2 && says err "2^31"; }
check "more patches than there are numbers for is refused" huge

every_sequence() {
    for sequence in random sobol halton halton:11,13,17,19; do
        for method in first-shot global extended local; do
            ends 0 solve "$scene" $quick --json -q --sequence $sequence --method $method -o room.csv || return
            awk -F': ' '/balance_error/ {exit !($2 + 0 < 1e-9)}' out || { cat out; return 1; }
        done
    done
    ends 2 solve "$scene" --sequence halton:4,6,5,7 && says err "4 and 6 have"
}
check "every method and sequence keeps the power balance, and bases that cannot work are refused" every_sequence

skip_and_pairing() {
    ends 0 solve "$scene" $quick -o a.csv && ends 0 solve "$scene" $quick --skip 1 -o b.csv && ends 0 solve "$scene" $quick \
        --pairing 2d -o c.csv && ! cmp -s a.csv b.csv && ! cmp -s a.csv c.csv && grep -q -- '--skip 1' b.csv
}
check "items can be skipped and taken in pairs, and the table says so" skip_and_pairing

too_short() { ends 2 solve "$scene" --patch-size 1 --lines 1000 --sequence hammersley:500 -o a.csv && lines_are err 3 && says err "ends after 500"; }
check "a sequence that is too short is refused" too_short

family_options() {
    ends 0 solve "$scene" $quick -q --method transillumination --bundle 16 -o a.csv && ends 2 solve "$scene" --method transillumination --bundle 0 &&
        ends 2 solve "$scene" $quick --bundle 16 && says err "no effect" &&
        ends 0 solve "$root/scenes/5cubes.obj" $quick --method reuse --important floor --replicates 2 -o b.csv && says err "important " && says err "noise" &&
        ends 0 solve "$root/scenes/5cubes.obj" $quick -q --json --method reuse --important view --eye 1.5,1,2.9 --target 1.5,1,0 --replicates 2 -o c.csv &&
        says out '"important_relative_standard_error": 0' && ends 2 solve "$root/scenes/5cubes.obj" $quick --method reuse --important view && says err "expected --eye and --target" &&
        ends 1 solve "$root/scenes/5cubes.obj" $quick --method reuse --important nothing && says err "no object or material is called 'nothing'" &&
        ends 2 solve "$root/scenes/5cubes.obj" $quick --method jacobi --important floor && says err "no effect"
}
check "the options of the family of methods are followed, and refused where they have no effect" family_options

budget_options() {
    ends 0 solve "$scene" $quick -q --json --method extended --power-per-line 0.01 --threshold 0 -o a.csv && says out '"method": "extended"' &&
        ends 0 solve "$scene" $quick -q --method extended --steps 2 --ratio 1 -o b.csv && ends 0 solve "$scene" $quick -q --method local \
        --estimator absorption -o c.csv && ends 2 solve "$scene" --method extended --ratio 1 --power-per-line 2 && says err "exclude" &&
        ends 2 solve "$scene" --method extended --threshold -1 && ends 2 solve "$scene" --method extended --steps 0
}
check "the budget of the extended first shot follows its options" budget_options

stages() {
    ends 0 solve "$scene" $quick --method extended --verbose -o a.csv && says err "pass 1" && says err "pass 2" && says err "global pass" || return
    awk '/^  (pass|global)/ { sum = $(NF - 3) + $(NF - 2) + $(NF - 1) + $NF; d = $(NF - 4) - sum; if (d * d > 1e-6) exit 1; ++n }
        END { exit n < 3 }' err
}
check "--verbose shows the power balance of every stage, and each closes" stages

camera() {
    ends 0 solve "$scene" $quick -q --eye 1.5,1.5,2.9 --target 1.5,1.4,0 --fov 70 -o a.ppm &&
        ends 0 solve "$scene" $quick -q --eye 1.5,1.5,2.9 --target 1.5,1.4,0 --fov 40 -o b.ppm && ! cmp -s a.ppm b.ppm &&
        ends 2 solve "$scene" $quick --eye 1,1 -o a.ppm && ends 2 solve "$scene" $quick --up 0,0,0 -o a.ppm
}
check "the camera follows its options" camera

# Single precision keeps 7 digits of a value; nothing seen is 0.
shown_error() {
    ends 0 solve "$scene" --lines 2^14 -q --replicates 4 --show error $small 0.4 -o error.pfm -o error.csv || return
    { grep -v '^#' error.csv | awk -F, 'NR > 1 { print $20, "table" } END { print 0, "table" }'
        tail -n +4 error.pfm | od -An -v -tf4 | tr -s ' ' '\n' | awk 'NF && ++n % 3 == 1 { print $1, "pixel" }'; } | sort -g >values
    awk '{ value[NR] = $1; pixel[NR] = $2 == "pixel" }
        function near(i, by) { while (pixel[i]) i += by
            return i > 0 && i <= NR && (value[i] - value[here]) ^ 2 <= (1e-6 * value[here]) ^ 2 }
        END { for (here = 1; here <= NR; ++here) if (pixel[here]) {
                if (value[here] != value[here - 1]) ++different
                if (!near(here, 1) && !near(here, -1)) { print value[here], "is not in the table"; exit 1 } }
            exit different < 100 }' values
}
check "a PFM of the error holds the errors of the table" shown_error

shown_pictures() {
    for what in radiosity direct irradiance error unshot patches normals; do
        [ $what = error ] && replicates="--replicates 2" || replicates=
        ends 0 solve "$scene" --lines 2^14 -q $replicates --patch-size 0.4 --show $what --size 320x240 --samples 1 -o $what.ppm || return
        [ "$(head -c 2 $what.ppm)" = P6 ] && [ "$(wc -c <$what.ppm)" -gt 230400 ] || return
    done
    ends 0 solve "$scene" --lines 2^15 -q --tolerance 50% --patch-size 0.4 --show error --size 320x240 --samples 1 -o rounds.ppm || return
    # The legend's paper, of grey 32, is in the last row of the pictures with a legend and of no other.
    for what in radiosity direct irradiance error unshot patches normals rounds; do
        tail -c 960 $what.ppm | od -An -v -tu1 | tr -s ' ' '\n' | sort -u | tr -s '\n' ' ' >$what.row
    done
    grep -q '^ 32 $' error.row && cmp error.row irradiance.row && cmp error.row rounds.row && cmp error.row unshot.row || return
    for what in radiosity direct patches normals; do
        ! cmp -s error.row $what.row || return
    done
}
check "quantities have a legend, the room and its patches none" shown_pictures

gathered() {
    for threads in 1 2; do
        ends 0 solve "$scene" --lines 2^14 -q --patch-size 0.4 --shading gather --gather-rays 4 --size 64x48 --threads $threads -o $threads.ppm || return
    done
    cmp 1.ppm 2.ppm && ends 0 solve "$scene" --lines 2^14 -q --patch-size 0.4 --size 64x48 -o smooth.ppm && ! cmp -s 1.ppm smooth.ppm &&
        ends 2 solve "$scene" --gather-rays 8 && says err "no effect without --shading gather"
}

usual_lines() {
    ends 0 solve "$scene" --patches 50000 --method local -o usual.csv && ! grep -q "per patch" err &&
        grep -qE "^# run: method local, sequence sobol, 2[01][0-9]{5} lines, 4" usual.csv || return
    ends 0 solve "$scene" --patches 50000 --method local --lines 2^19 -o few.csv && says err "11 lines per patch" && says err "2^21 gives" || return
    ends 0 solve "$scene" --patches 400 --method local -o small.csv && grep -qE "^# run: method local, sequence sobol, 1[01][0-9]{5} lines, " small.csv
}
check "large scenes get more lines, and few are told" usual_lines

check "a gathered picture is the same for any number of threads, and unlike an interpolated one" gathered

by_default() {
    ends 0 solve "$scene" -o default.csv && grep -q "^# run: .* adaptive patches" default.csv &&
        ends 0 solve "$scene" --patches 400 -o equal.csv && ! grep -q "^# run: .* adaptive" equal.csv &&
        ends 0 solve "$scene" --patch-size 0.4 -o equal.csv && ! grep -q "^# run: .* adaptive" equal.csv &&
        [ "$(grep -v '^#' equal.csv | cut -d, -f10 | sort -u | wc -l)" -lt "$(grep -v '^#' default.csv | cut -d, -f10 | sort -u | wc -l)" ]
}
check "patches are adaptive where no option says how many or how large" by_default

adaptive() {
    for threads in 1 2; do
        ends 0 solve "$scene" --adaptive 900 --lines 2^14 --threads $threads --size 60x40 -o a-$threads.csv \
            -o a-$threads.png -o a-$threads.glb || return
        grep -qE "surfaces, (89[0-9]|900) patches" err || return
    done
    cmp a-1.csv a-2.csv && cmp a-1.png a-2.png && cmp a-1.glb a-2.glb &&
        awk -F, '$2 == 0 { areas[$10] = 1 } END { for (area in areas) ++n; exit n < 2 }' a-1.csv
}
check "with --adaptive patches of a surface have different sizes, the same for any number of threads" adaptive

adaptive_from() {
    ends 0 solve "$scene" --adaptive 200 --patches 100 --lines 2^14 --method global -o a.csv &&
        ends 1 solve "$scene" --adaptive 20 -o none.csv && says err "--adaptive: has 42 patches before" && [ ! -e none.csv ] &&
        ends 1 solve "$scene" --adaptive 200 --patch-size 0.2 -o b.csv && says err "expected more than that" &&
        ends 2 solve "$scene" --adaptive 0 -o b.csv && says err "--adaptive"
}
check "the coarse patches may be given; there must be fewer of them" adaptive_from
white_sky() {
    printf '%s\n' 'mtllib white.mtl' 'v 0 0 0' 'v 0 0 1' 'v 1 0 1' 'usemtl white' 'f 1 2 3' >white.obj
    printf '%s\n' 'newmtl white' 'Kd 1 1 1' >white.mtl
    for lines in 2^8 2^16; do
        ends 0 solve white.obj --sky 3 --lines $lines --json -o white.csv && grep -qE '"mean_radiosity": (3,|3\.00000|2\.99999)' out ||
            return
    done
}
check "what is white and absorbs nothing is lit by the sky all the same" white_sky
finish
