# States of runs: kept, interrupted, resumed, rendered again, compared; split into shards and merged.
. "$2/tests/cli/check.sh"
scene=$root/scenes/5cubes.obj
quick="--patch-size 0.4 --quiet"

# usage: ends_by_signal SIGNAL ARGS...     sends it as soon as the state is there; exit status as of ends
interrupted() {
    signal=$1
    shift
    rm -f run.state
    "$program" solve "$scene" --patch-size 0.4 --lines 2^40 --method first-shot --state run.state --save-every 0.01s \
        "$@" >out 2>err &
    tries=0
    until [ -f run.state ] || [ $((tries += 1)) -gt 2400 ]; do sleep 0.05; done
    kill -"$signal" $!
    wait $!
    status=$?
    [ $status -eq 130 ] || { echo "exit status $status"; cat err; return 1; }
}

interrupt() {
    interrupted TERM -o then.csv -o then.png --size 32x32 && says err "interrupted after" && says err "--resume continues" &&
        [ -s then.csv ] && [ -s then.png ] && [ -z "$(find . -name '*.part*')" ]
}
on_posix check "SIGTERM ends a run in good order: outputs as of then, exit status 130" in_three_tries interrupt

# usage: in_time FILE       waits until there is something in it, but not for ever
in_time() {
    for tries in $(seq 200); do
        [ -s "$1" ] && return
        sleep 0.1
    done
    return 1
}
# By the terminal of script(1), once the run has saved its state. Without it the run takes a minute.
ctrl_c() {
    rm -f run.state then.csv
    { in_time run.state; printf '\003'; in_time then.csv; } |
        scene=$scene quick=$quick program=$program script -qec \
            'exec "$program" solve "$scene" $quick --method local --lines 2^28 --state run.state --save-every 0.1s -o then.csv' \
            /dev/null >out
    [ $? -eq 130 ] && [ -s then.csv ] && [ -z "$(find . -name '*.part*')" ]
}
# Where a shell has started the tests in the background, SIGINT is ignored, by the program too.
hears_ctrl_c() { ! sh -c 'kill -INT $$; :' 2>/dev/null && script -qec true /dev/null >out 2>&1 </dev/null; }
hears_ctrl_c && check "and so does Ctrl-C" in_three_tries ctrl_c

interrupt_to_state() {
    interrupted TERM -o kept.state && ends 1 render kept.state -o x.png && says err "not finished"
}
on_posix check "an interrupted run leaves its state also as an output" in_three_tries interrupt_to_state

# Left after half of the lines' time or so, resumed, the same bytes as in one go. Without replicates, for every method: torture.sh.
goes_on() {
    set -- --lines 2^20 --replicates 3 && rm -f run.state
    ends 0 solve "$scene" $quick "$@" -o whole.csv || return
    "$program" solve "$scene" $quick "$@" --state run.state --save-every 0.001s -o part.csv &
    for wait in 1 2 3 4 5 6 7 8 9 10; do [ -f run.state ] && break; sleep 0.02; done
    kill -KILL $! 2>/dev/null
    wait $! 2>/dev/null
    ends 0 solve "$scene" $quick "$@" --state run.state --resume --threads 1 -o part.csv && cmp whole.csv part.csv
}
check "killed replicates that are resumed give the same bytes" goes_on

finished() {
    rm -f done.state
    ends 0 solve "$scene" $quick --lines 20000 --state done.state -o first.csv && cp done.state before.state || return
    ends 0 solve "$scene" --patch-size 0.4 --lines 20000 --state done.state --resume -o again.csv &&
        says err "resuming from done.state" && cmp first.csv again.csv && cmp done.state before.state || return
    ends 0 solve "$scene" $quick --lines 20000 --from-state before.state --state copy.state -o again.csv && cmp before.state copy.state
}
check "a finished run that is resumed writes the same outputs and the same state, into another file too" finished

longer() {
    ends 0 solve "$scene" $quick --lines 80000 --state done.state --resume -o longer.csv || return
    cp before.state other.state
    ends 0 solve "$scene" $quick --lines 80000 --state other.state --resume --threads 1 -o other.csv &&
        cmp longer.csv other.csv && cmp done.state other.state && ! cmp -s first.csv longer.csv || return
    ends 1 solve "$scene" $quick --lines 30000 --state done.state --resume -o shorter.csv && says err "80000 lines" &&
        [ ! -e shorter.csv ]
}
check "a finished run goes on to more lines, not to fewer" longer

# usage: refused TEXT FILE OPTIONS...      exit 1, one line, and the file is as it was
refused() {
    text=$1 file=$2
    shift 2
    cp "$file" untouched
    ends 1 solve "$scene" $quick --state "$file" "$@" -o x.csv && silent out && lines_are err 1 && says err "$text" &&
        cmp "$file" untouched && [ ! -e x.csv ]
}
messages() {
    cp before.state a.state
    refused "exists" a.state --lines 20000 &&
        refused "made with --sequence sobol, not with --sequence halton" a.state --lines 20000 --sequence halton --resume &&
        refused "no --two-sided, not with --two-sided" a.state --lines 20000 --two-sided --resume &&
        refused "no --flip, not with --flip" a.state --lines 20000 --flip --resume || return
    head -c 3000 before.state >short.state
    { head -c 4000 before.state && printf x && tail -c +4002 before.state; } >bent.state
    printf 'multipath state 2      \n12345678' >newer.state
    echo "something else" >foreign.state
    : >empty.state
    refused "damaged" short.state --resume && refused "damaged" bent.state --resume &&
        refused "newer version" newer.state --resume && refused "not a state of multipath" foreign.state --resume &&
        refused "not a state of multipath" empty.state --resume
}
check "damaged, foreign, newer and other states each have their message and are left alone" messages

other_scene() {
    sed 's/^Kd 0.8.*/Kd 0.1 0.1 0.1/; s/^Kd 0.7.*/Kd 0.1 0.1 0.1/' "$root"/scenes/5cubes.mtl >5cubes.mtl
    cp "$scene" here.obj
    ends 1 solve here.obj $quick --lines 20000 --state a.state --resume -o x.csv && says err "scene"
}
check "the state of a scene that has changed is refused" other_scene

without_state() {
    ends 2 solve "$scene" --resume && says err "--state" && ends 2 solve "$scene" --save-every 5s && says err "--state" &&
        ends 2 solve "$scene" --state "" && ends 1 solve "$scene" --from-state none.state && says err none.state
}
check "options of states without a state say so" without_state

rendered() {
    ends 0 solve "$scene" $quick --lines 20000 -o all.state -o direct.csv -o direct.png --exposure 2 --size 60x40 || return
    mkdir -p elsewhere && cp all.state elsewhere && cd elsewhere || return
    ends 0 render all.state -o again.csv -o again.png --exposure 2 --size 60x40 --quiet &&
        cmp again.csv ../direct.csv && cmp again.png ../direct.png && cd ..
}
check "render makes the same pictures and tables from the state alone" rendered

recorded() {
    ends 0 solve "$root/scenes/cornell.obj" $quick --lines 2000 --lamp red=3 --lamp green=2 -o two.csv -o two.state &&
        ends 0 render two.state -q -o again.csv && grep '^# command' again.csv | grep -q -- '--lamp red=3 --lamp green=2' || return
    ends 1 solve "$root/scenes/cornell.obj" $quick --lines 3000 --lamp green=2 --from-state two.state && says err "made with --lamp red=3 --lamp green=2, not with --lamp green=2" &&
        ends 2 render two.state -o none-made.state && says err "render writes no states" && [ ! -e none-made.state ]
}
check "a state records every value of an option; render makes no states" recorded

compared() {
    ends 0 compare all.state direct.csv && says out "MSE        0 W" && ends 0 compare direct.csv all.state --json
}
check "compare reads states" compared

adaptive() {
    ends 0 solve "$scene" $quick --adaptive 700 --lines 8000 -o fine.csv -o fine.state -o fine.png --size 60x40 &&
        ends 0 render fine.state -o again.csv -o again.png --size 60x40 --quiet && cmp fine.csv again.csv &&
        cmp fine.png again.png || return
    ends 0 solve "$scene" $quick --adaptive 700 --lines 8000 -o whole.csv && in_shards part --adaptive 700 --lines 8000 &&
        ends 0 merge part-1.state part-2.state part-3.state -o sum.csv && cmp whole.csv sum.csv &&
        refused "made with --adaptive 700" fine.state --adaptive 600 --lines 8000 --resume
}

# usage: in_shards STATES OPTIONS...     of three shards
in_shards() {
    name=$1
    shift
    for i in 1 2 3; do ends 0 solve "$scene" $quick "$@" --shard $i/3 --state $name-$i.state || return; done
}
check "adaptive patches come back from states, and from those of shards" adaptive

merged() {
    ends 0 solve "$scene" $quick "$@" -o whole.csv && in_shards count "$@" &&
        ends 0 merge count-3.state count-1.state count-2.state --quiet -o sum.csv && cmp whole.csv sum.csv
}
fresh() { rm -f count-*.state ray-*.state counted.state; }
merge_reuse() { fresh; merged --lines 10000 && fresh && merged --lines 50000 && fresh && merged --lines 50001 --memory 2MB --sequence random; }
check "merged shards of reuse give the bytes of one run" merge_reuse

rounds() {
    fresh
    ends 0 solve "$scene" $quick --lines 50000 -o whole.csv && in_shards count --lines 50000 &&
        ends 0 merge count-?.state -o counted.state && in_shards ray --lines 50000 --from-state counted.state &&
        ends 0 merge ray-?.state --quiet -o sum.csv -o sum.state && cmp whole.csv sum.csv || return
    ends 0 render sum.state --quiet -o sum2.csv && cmp sum.csv sum2.csv || return
    ends 0 solve "$scene" $quick --lines 50000 --from-state counted.state -o rest.csv && cmp whole.csv rest.csv
}
check "so do shards of both rounds" rounds

average() {
    for method in $(methods | grep -v reuse); do
        rm -f walk-?.state
        for i in 1 2; do
            ends 0 solve "$scene" $quick --method $method --lines 100000 --shard $i/2 --state walk-$i.state -o walk-$i.csv || return
        done
        ends 0 merge walk-2.state walk-1.state -o mean.csv && ! cmp -s walk-1.csv walk-2.csv || return
        awk -F, '/^[0-9]/ { s[FILENAME] += $17 * $10 } END { m = (s["walk-1.csv"] + s["walk-2.csv"]) / 2
            exit !(s["mean.csv"] > 0.999 * m && s["mean.csv"] < 1.001 * m) }' walk-1.csv walk-2.csv mean.csv || { echo "$method"; return 1; }
    done
}
check "shards of all methods but reuse are averaged" average

refused_merges() {
    ends 1 merge count-1.state count-3.state -o x.csv && says err "each of the shards 1 to 3 once, got count-1.state (1), count-3.state (3)" &&
        ends 1 merge count-1.state count-1.state count-2.state -o x.csv && says err "once, got count-1.state (1), count-1.state (1)" &&
        ends 1 merge count-1.state count-2.state -o x.csv && says err "once, got count-1.state (1), count-2.state (2)" || return
    ends 0 solve "$scene" $quick --lines 50000 --seed 2 --sequence random --shard 2/3 --state seed.state &&
        ends 1 merge count-1.state seed.state count-3.state -o x.csv && says err "sequence" || return
    ends 1 merge count-1.state ray-2.state count-3.state -o x.csv && says err "not as far" && [ ! -e x.csv ]
}
check "merge refuses what is missing, there twice, or of other runs" refused_merges

unfinished_merge() {
    for i in 1 2; do
        interrupted TERM --shard $i/2 && says err "--resume continues" && mv run.state half-$i.state || return
    done
    ends 1 merge half-1.state half-2.state -o x.csv && lines_are err 1 && says err "half-1.state: this shard is not finished" &&
        [ ! -e x.csv ]
}
on_posix check "and shards that were interrupted" unfinished_merge

shard_options() {
    ends 2 solve "$scene" --shard 4/3 --state x.state && ends 2 solve "$scene" --shard 0/3 --state x.state &&
        ends 2 solve "$scene" --shard 1/3 --lines 2 --state x.state && says err "more shards than lines" &&
        ends 2 solve "$scene" --shard 1 --state x.state && says err "3/16" && ends 2 solve "$scene" --shard 1/3 &&
        says err "--state" && ends 2 solve "$scene" --shard 1/3 --state x.state -o x.png && says err "no result of its own" &&
        ends 2 solve "$scene" --shard 1/3 --replicates 2 --state x.state && says err "replicates" && [ ! -e x.state ]
}
check "--shard says what it needs" shard_options

endless() {
    for command in "render /dev/zero" "merge /dev/zero" \
        "solve $scene $quick --from-state /dev/zero" "solve $scene $quick --state /dev/zero --resume"; do
        (ulimit -v 4000000 && ends 1 $command) && says err "/dev/zero" && lines_are err 1 || { echo "$command"; return 1; }
    done
}
# A sanitizer takes all addresses there are.
if (ulimit -v 4000000 && "$program" --version >/dev/null 2>&1); then
    on_posix check "a device without an end is no file to read" endless
fi

from_pipe() {
    cat done.state | "$program" render /dev/stdin --quiet -o piped.csv && ends 0 render done.state --quiet -o read.csv &&
        cmp piped.csv read.csv
}
on_posix check "a state can come through a pipe" from_pipe
finish
