# `multipath check`: the report of a scene, as text and as JSON.
. "$2/tests/cli/check.sh"
scene=$root/scenes/5cubes.obj

report() {
    ends 0 check "$scene" --lines 20000 && silent err && for word in R_ave Phi_T n_int "(4)" "9 W" \
        "42 surfaces"; do says out "$word" || return; done
}
check "a sound scene is reported with exit code 0" report

json() {
    ends 0 check "$scene" --lines 20000 --json && silent err && for key in average_reflectance intersections \
        intersections_measured lit_fraction secondary_reflectance \
        ratio_first_shot ratio_extended threshold_radiosity escaped_share back_face_share emitters findings; do
        says out "\"$key\":" || return
    done
    says out '"surfaces": 42,'
}
check "--json gives the same figures to programs" json

size() {
    ends 0 check "$root/scenes/4chairs.obj" --lines 1000 &&
        says out "size: 7.25 x 3.05 x 7.25 m from (-3.625, 0, -3.625) to (3.625, 3.05, 3.625)"
}
check "width, height and depth of a scene are told, and where it lies" size

repeatable() {
    ends 0 check "$scene" --lines 20000 --threads 1 && mv out one && ends 0 check "$scene" --lines 20000 --threads 2 && cmp out one
}
check "the report does not depend on the number of threads" repeatable

covered_floor() {
    cat >covered.obj <<'OBJ'
mtllib covered.mtl
v 0 0 0
v 2 0 0
v 2 0 2
v 0 0 2
v 0 2 0
v 2 2 0
v 2 2 2
v 0 2 2
usemtl lamp
o floor
f 1 4 3 2
usemtl wall
o walls
f 5 6 7 8
f 1 2 6 5
f 3 4 8 7
f 4 1 5 8
f 2 3 7 6
v 0.5 0 0.5
v 1.5 0 0.5
v 1.5 0 1.5
v 0.5 0 1.5
v 0.5 1 0.5
v 1.5 1 0.5
v 1.5 1 1.5
v 0.5 1 1.5
o box
f 13 16 15 14
f 10 9 13 14
f 12 11 15 16
f 9 12 16 13
f 11 10 14 15
OBJ
    printf 'newmtl wall\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0.5 0.5 0.5\nKe 1 1 1\n' >covered.mtl
    ends 1 check covered.obj --lines 20000 && says out WRONG && says out "lost" && says out "box (line" && says out "bottom" &&
        says out "from 4 m^2" && grep -q " 0 % escapes, [0-9.]*[1-9]" out &&
        ends 0 solve covered.obj --lines 20000 -o covered.csv && says err "multipath check" &&
        ends 0 check covered.obj --lines 20000 --two-sided
}
check "a box without a bottom on a floor is found, named and helped" covered_floor

# A lamp whose front looks away from the only wall.
dark() {
    printf 'mtllib dark.mtl\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\n' >dark.obj
    printf 'usemtl wall\nf 1 4 3 2\nusemtl lamp\nf 5 8 7 6\n' >>dark.obj
    printf 'newmtl wall\nKd 0.5\nnewmtl lamp\nKe 1\n' >dark.mtl
    "$program" check dark.obj --lines 20000 >out
    says out "- first shot, " && says out "no light falls on reflecting surfaces" && ! grep -w nan out || return
    "$program" check dark.obj --lines 20000 --json >out
    says out '"ratio_first_shot": null'
}
check "where the lamp lights nothing, (3) has no value, and the report says why" dark

# Without any lamp.
lampless() {
    printf 'v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 4 3 2\n' >plate.obj
    ends 1 check plate.obj && says err "plate.obj: no emitter" && says err "to light it by sky and sun: --sky 10 --sun 150,40,20"
}
check "a file without lamps is refused with a command that lights it" lampless

# A hole of 2 mm in a room of 2 m loses 0.04 % of the light, three lamps above the ceiling have 0.1 % of the power.
next_to_sound() {
    {
        printf '%s\n' 'mtllib sound.mtl' 'v 0 0 0' 'v 2 0 0' 'v 2 0 1.998' 'v 0 0 1.998' 'v 0 2 0' 'v 2 2 0' 'v 2 2 2' \
            'v 0 2 2' 'v 2 0 2' 'v 0 0 2' 'usemtl wall' 'f 4 3 2 1' 'f 1 2 6 5' 'f 9 10 8 7' 'f 10 1 5 8' 'f 2 9 7 6' \
            'usemtl lamp' 'f 5 6 7 8'
        for x in 0.1 0.2 0.3; do printf '%s\n' "v $x 3 0.1" "v $x 3 0.16" "v ${x}6 3 0.1" 'f -3 -2 -1'; done
    } >sound.obj
    printf '%s\n' 'newmtl wall' 'Kd 0.5' 'newmtl lamp' 'Kd 0.5' 'Ke 7 5 3' >sound.mtl
    ends 0 check sound.obj --lines 2^18 && says out "  note   sound.obj:" && says out "escapes through gaps, too little" &&
        says out "emitters that light nothing, facing away from everything (0.135 % of the source power): a face (line 23)" && ! grep WRONG out
}
check "losses too small to matter are notes, and equal ones one row" next_to_sound

unreadable() { ends 1 check nowhere.obj && lines_are err 1 && silent out; }
check "a scene that cannot be read is one line and exit code 1" unreadable
# A power that underflows would leave no source to begin with.
denormal_lamp() {
    sed 's/^Ke .*/Ke 1e-323 1e-323 1e-323/' "$root/scenes/cube.mtl" >cube.mtl
    cp "$root/scenes/cube.obj" cube.obj
    for command in check explain "solve -o dark.csv --method first-shot" "study -o dark.svg"; do
        ends 1 $command cube.obj && lines_are err 1 && says err "no emitter" && says err "above 0 (1e-30 or more)" || return
    done
}
check "a light too small to compute with is none, and that is said" denormal_lamp

one_denormal_lamp() {
    cp "$root/scenes/cube.obj" cube.obj
    for light in 1e-323 0; do
        sed "s/^Ke 1 1 1/Ke $light $light $light/" "$root/scenes/cube.mtl" >cube.mtl
        ends 0 solve cube.obj --lines 1000 --patches 100 --method first-shot --quiet -o $light.csv || return
        grep -v '^#' $light.csv >$light.rows
    done
    cmp 1e-323.rows 0.rows
}
check "and beside other lights it is dark" one_denormal_lamp
finish
