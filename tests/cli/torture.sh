# Runs are killed (SIGKILL) at random moments, KILLS of them (8, one of each method), and resumed, some of them several times: always the same bytes.
. "$2/tests/cli/check.sh"
scene=$root/scenes/5cubes.obj
common="--patch-size 0.3 --quiet"

# Seeded by nothing: every test run kills at other moments.
random_below_one() { od -An -N4 -tu4 /dev/urandom | awk '{ print $1 / 4294967296 }'; }

now() { date +%s.%N; }

# The run number $1: every method, other sequences and numbers of threads in turn.
# usage: run_options NUMBER
run_options() {
    set -- "$1" $(($1 % $(methods | wc -l))) $(($1 % 3))
    method=$(methods | sed -n "$(($2 + 1))p")
    sequence=$(echo random sobol halton-permuted | cut -d' ' -f$(($3 + 1)))
    echo "--method $method --sequence $sequence --lines 2^20"
}

# Kills the run of these options after a random part of its time; 0 if it was killed before its end.
# usage: kill_one SECONDS OPTIONS...
kill_one() {
    pause=$(awk -v t="$1" -v r="$(random_below_one)" 'BEGIN { print t * r }')
    shift
    "$program" solve "$scene" $common "$@" --state run.state --resume --save-every 0.001s -o killed.csv 2>/dev/null &
    sleep "$pause"
    kill -KILL $! 2>/dev/null
    wait $! 2>/dev/null
    [ $? -eq 137 ]
}

# usage: one_run NUMBER
one_run() {
    options=$(run_options "$1")
    start=$(now)
    ends 0 solve "$scene" $common $options -o whole.csv || return
    seconds=$(awk -v a="$start" -v b="$(now)" 'BEGIN { print 1.2 * (b - a) }')
    rm -f run.state killed.csv
    tries=0
    until kill_one "$seconds" $options; do
        tries=$((tries + 1))
        [ $tries -lt 20 ] || { echo "never killed in time: $options"; return 1; }
        rm -f run.state killed.csv
    done
    kills=1
    [ $(($1 % 4)) -eq 0 ] && kill_one "$seconds" $options && kills=2
    [ -f run.state ] && resumed=yes || resumed=no
    ends 0 solve "$scene" $common $options --state run.state --resume --threads $((1 + $1 % 2)) -o killed.csv &&
        cmp whole.csv killed.csv || { echo "$options"; return 1; }
    echo "$kills kills, state there: $resumed: $options"
    echo $resumed >>../torture.count
}

kills_wanted=${KILLS:-8}
killed() {
    : >torture.count
    number=0
    while [ $number -lt "$kills_wanted" ]; do
        mkdir $number && (cd $number && one_run $number) || return
        rm -r $number
        number=$((number + 1))
    done
}
check "$kills_wanted runs killed at random moments and resumed give the same bytes" killed

many_had_a_state() { [ $(($(grep -c yes torture.count) * 3)) -ge "$kills_wanted" ] || { sort torture.count | uniq -c; return 1; }; }
check "most of them left a state to go on from" many_had_a_state

finish
