# Ctrl-C, SIGTERM and SIGHUP: every command ends, at the latest at the second one; what is complete stays, nothing half written does.
. "$2/tests/cli/check.sh"
scene=$root/scenes/cube.obj
quick="--lines 1000 --patches 100 --size 8x8 --quiet"
slow_picture="--threads 1 --shading gather --gather-rays 1000000 --size 500x500"

# Runs the program in the background with all files in the folder `halted` and its number in `pid`, until MOMENT
# succeeds; its exit status will be in `status`.
# usage: begin MOMENT COMMAND ARGS...
begin() {
    moment=$1
    shift
    rm -rf halted pid status && mkdir halted || return
    { TMPDIR=halted sh -c 'echo $$ >pid; exec "$@"' sh "$program" "$@" >out 2>err; echo $? >status; } &
    for tries in $(seq 1000); do
        $moment && return
        [ ! -s status ] || { echo "ended too early, exit status $(cat status)"; cat err; return 1; }
        sleep 0.02
    done
    echo "the moment to send a signal never came"
    kill -KILL "$(cat pid)"
    return 1
}
ends_interrupted() {
    for tries in $(seq 200); do
        [ -s status ] && break
        sleep 0.1
    done
    [ -s status ] || { echo "does not end"; kill -KILL "$(cat pid)"; return 1; }
    [ "$(cat status)" -eq 130 ] || { echo "exit status $(cat status)"; cat err; return 1; }
    says err "interrupted"
}
signal() { kill -"$1" "$(cat pid)"; }
halted_is() {
    [ "$(ls -A halted | tr '\n' ' ')" = "$1" ] && return
    ls -A halted
    return 1
}
begun() { [ -n "$(find halted -name ".*.part")" ]; }
saved() { [ -f halted/run.state ]; }

# usage: ends_at_once SIGNAL COMMAND ARGS...
ends_at_once() {
    name=$1
    shift
    begin begun "$@" && signal "$name" && ends_interrupted && lines_are err 1 && halted_is ""
}
check "SIGTERM ends points at once, and nothing half written is left" ends_at_once TERM points --count 2^40 -o halted/a.csv
# Under nohup(1) the signal is ignored, by the program too.
hangs_up() { ! sh -c 'kill -HUP $$; :' 2>/dev/null; }
hangs_up && check "so does SIGHUP, of a terminal that is closed" ends_at_once HUP points --count 2^40 -o halted/a.csv
check "and SIGTERM explain" ends_at_once TERM explain "$scene" --method global --of 2^42 --first 2^40 -o halted/a.svg
check "a state to render" ends 0 solve "$scene" $quick -o all.state
check "and render" ends_at_once TERM render all.state --quiet $slow_picture -o halted/b.png

# After the first line a run solves for the light of its lines, which may take long.
prepares() {
    begin begun solve "$root/scenes/4chairs.obj" --patches 14000 --method reuse --lines 2^30 --quiet -o halted/a.csv &&
        signal TERM || return
    sleep 0.5
    [ -s status ] || signal TERM
    ends_interrupted && halted_is ""
}
check "a run that prepares has nothing to write" prepares

fifo() {
    rm -f fifo.csv && mkfifo fifo.csv &&
        ends_at_once TERM solve "$scene" $quick -o halted/a.csv -o fifo.csv
}
check "a pipe that nobody reads does not keep the program from ending" fifo

# usage: run_of SOLVE-OPTIONS...      endless; its state is saved now and then
run_of() {
    begin saved solve "$scene" --patches 100 --lines 2^40 --method local --quiet --state halted/run.state --save-every 0.01s "$@"
}
quick_outputs() {
    run_of --size 8x8 -o halted/a.csv -o halted/b.png && signal "$1" && ends_interrupted && says err "interrupted after" &&
        lines_are err 1 && halted_is "a.csv b.png run.state "
}
check "what is quick is written as of then" in_three_tries quick_outputs TERM
hangs_up && check "and at SIGHUP, too" in_three_tries quick_outputs HUP

# The first signal stops the lines; the table is complete before the second one, the picture is not.
second_signal() {
    echo old >kept.png
    run_of $slow_picture -o kept.png -o halted/a.csv && signal TERM || return
    until grep -q "interrupted after" err || [ -s status ]; do sleep 0.1; done
    sleep 1
    signal TERM
    ends_interrupted && says err "not written: kept.png" && lines_are err 2 && halted_is "a.csv run.state " &&
        [ "$(cat kept.png)" = old ] && [ -s halted/a.csv ]
}
check "a second signal ends the run at once; a picture that is not complete is named, and its old file stays" \
    in_three_tries second_signal

# The state appears when the run is done, before the picture.
# usage: while_it_draws OUTPUT OPTIONS...
while_it_draws() {
    output=$1
    shift
    begin saved solve "$scene" --lines 4000 --patches 100 --quiet --state halted/run.state -o "halted/$output" -o halted/a.csv "$@" &&
        signal TERM && ends_interrupted && says err "not written: halted/$output" && lines_are err 1 &&
        halted_is "a.csv run.state " && [ "$(grep -c -v '^#' halted/a.csv)" -gt 60 ]
}
check "a signal during a large picture costs the picture, not the table" in_three_tries while_it_draws b.png --size 6000x6000 --samples 100
check "and one during a picture that gathers light" in_three_tries while_it_draws b.ppm $slow_picture

# A shell starts background jobs with SIGINT ignored.
ignored() {
    run_of -o halted/a.csv && signal INT
    sleep 0.5
    [ ! -s status ] || { echo "ended"; cat err; return 1; }
    signal TERM && ends_interrupted
}
check "a signal that the program was started to ignore does not end a run" ignored
finish
