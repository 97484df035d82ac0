# The exam as a user takes it: it passes, it fails when a law is broken, and it examines scenes.
. "$2/tests/cli/check.sh"

whole() {
    ends 0 selftest -o exam.csv && tail -n 1 out | grep -Eqx '[1-9][0-9]+ passed, 0 failed' || return
    for word in local global first-shot extended reuse random sobol-owen halton kronecker furnace screened lines points; do
        says out "$word" || return
    done
    grep -q '^# command: multipath selftest' exam.csv && # as many rows as were passed
        [ "$(grep -c ',passed$' exam.csv)" = "$(tail -n 1 out | sed 's/ .*//')" ]
}
check "the whole exam passes, with every method and sequence" whole

# The same cases have passed with all laws in force.
# usage: caught LAW CASE
caught() {
    ends 1 selftest --case "$2" --break "$1" --quiet && says out "$2" && says out WRONG &&
        tail -n 1 out | grep -Eqx '[0-9]+ passed, [1-9][0-9]* failed'
}
check "power that flows one way only is caught" caught bidirectional stages
check "rays without Lambert's cosine are caught" caught cosine stages
check "lines that crowd are caught" caught crossings lines
check "a forecast that is not sent is caught" caught forecast stages
check "items of the wrong dimension are caught" caught pairing lines
check "surfaces that reflect too little are caught" caught reflectance screened
check "runs that repeat each other are caught" caught replicates stages
check "screens that let light through are caught" caught visibility screened

hidden() { ends 0 selftest --help && says out "[SCENE.obj]" && ! grep -q -e --break out; }
check "how to break laws is not in the help" hidden

same_table() {
    ends 0 selftest --case points --case stages --threads 1 && mv out one.txt &&
        ends 0 selftest --case points --case stages --threads 3 && cmp out one.txt || return
    ends 0 selftest --case points --quiet && lines_are out 1
}
check "the table does not depend on the threads; chosen cases and only failures can be shown" same_table

scene() {
    ends 0 selftest "$root/scenes/5cubes.obj" --patch-size 0.5 -o scene.csv || return
    for word in n_int "row sum" reciprocity "rays, lines" "power gained or lost" agreement; do says out "$word" || return; done
    grep -Eq '^# scene: [0-9a-f]{16}$' scene.csv
}
check "a scene is examined: crossings, row sums, reciprocity, balance, agreement of the methods" scene

caught_in_scene() {
    ends 1 selftest "$root/scenes/cube.obj" --case surfaces --break cosine --quiet && says out "rays, lines" && says out WRONG
}
check "and a law broken in it is caught" caught_in_scene

wrong_usage() {
    ends 2 selftest --case furnance && says err "did you mean furnace" &&
        ends 2 selftest --patch-size 1 && says err "--patch-size has no effect without SCENE.obj" &&
        ends 2 selftest --break gravity && says err "expected one of bidirectional" && ends 1 selftest none.obj && says err none.obj
}
check "wrong cases, options without a scene and missing scenes are refused" wrong_usage
finish
