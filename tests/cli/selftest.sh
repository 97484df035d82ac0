# The selftest as a user takes it: it passes, its table can be chosen from, and it checks scenes.
. "$2/tests/cli/check.sh"

# The table of all scenes takes half a minute of one processor: `./multipath selftest` tells.
known_scene() {
    ends 0 selftest --case perpendicular --threads 1 -o one.csv && tail -n 1 out | grep -Eqx '[1-9][0-9]+ passed, 0 failed' || return
    for word in $(methods) random sobol-owen halton kronecker perpendicular; do
        says out "$word" || return
    done
    grep -q '^# command: multipath selftest' one.csv && # as many rows as were passed
        [ "$(grep -c ',passed$' one.csv)" = "$(tail -n 1 out | sed 's/ .*//')" ]
}
check "a known scene passes, with every method and sequence" known_scene

# Modelled to be seen from outside.
scene() {
    sed 's/^f \(.*\) \(.*\) \(.*\) \(.*\)/f \4 \3 \2 \1/' "$root/scenes/cube.obj" >outward.obj && cp "$root/scenes/cube.mtl" . &&
        ends 0 selftest outward.obj --flip --patch-size 0.5 --quiet -o scene.csv && lines_are out 1 || return
    for word in "power gained or lost" "least B - E" agreement; do says scene.csv "$word" || return; done
    grep -Eq '^# scene: [0-9a-f]{16}$' scene.csv
}
check "a scene is checked: balance of power, agreement of the methods; only failures can be shown" scene

wrong_usage() {
    ends 2 selftest --case furnance && says err "got 'furnance'" &&
        ends 2 selftest --patch-size 1 && says err "--patch-size has no effect without SCENE.obj" &&
        ends 2 selftest "$root/scenes/5cubes.obj" --case furnace && says err "--case has no effect with SCENE.obj" &&
        ends 1 selftest none.obj && says err none.obj
}
check "wrong cases, options without effect and missing scenes are refused" wrong_usage
finish
