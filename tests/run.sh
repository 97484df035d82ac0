# Runs every test, shows what failed, and ends with the line "N passed, N failed".
# LEAVE_OUT names scripts to leave out. UNIT_ARGS are for the unit tests, such as -tse=statistics to leave out the long ones that prove no more under sanitizers.
# usage: run.sh UNIT_TESTS PROGRAM BUILD
[ $# -eq 3 ] || { echo "usage: run.sh UNIT_TESTS PROGRAM BUILD" >&2; exit 2; }
absolute() { echo "$(cd "$(dirname "$1")" && pwd)/$(basename "$1")"; }
root=$(cd "$(dirname "$0")/.." && pwd) || exit 1
unit_tests=$(absolute "$1")
program=$(absolute "$2")
scratch=$(absolute "$3")/test-run
rm -rf "$scratch" && mkdir -p "$scratch" || exit 1
LC_ALL=C
export LC_ALL

# Adds the counts. Whatever ended badly or counted nothing, yet counted no failure, has crashed: one failure more.
# usage: tally NAME STATUS LOG "PASSED FAILED"
passed=0 failed=0
tally() {
    set -- "$1" "$2" "$3" ${4:-0 0}
    passed=$((passed + $4)) failed=$((failed + $5))
    [ "$2" -eq 0 ] && [ "$4" -gt 0 ] && [ "$5" -eq 0 ] && return
    grep -v '^[0-9]* passed, [0-9]* failed$' "$3"
    [ "$5" -gt 0 ] && return
    echo "FAILED: $1 did not run to its end (exit status $2)"
    failed=$((failed + 1))
}

# Mostly on one processor: the scripts run meanwhile.
(cd "$root" && "$unit_tests" $UNIT_ARGS) >"$scratch/unit_tests.log" 2>&1 &
unit_tests_process=$!

for script in "$root/tests/include_order_test.sh" "$root"/tests/cli/*.sh; do
    name=$(basename "$script" .sh)
    case " check $LEAVE_OUT " in *" $name "*) continue ;; esac
    mkdir "$scratch/$name"
    (cd "$scratch/$name" && sh "$script" "$program" "$root") >"$scratch/$name.log" 2>&1
    tally "$name.sh" $? "$scratch/$name.log" "$(tail -n 1 "$scratch/$name.log" |
        sed -n 's/^\([0-9][0-9]*\) passed, \([0-9][0-9]*\) failed$/\1 \2/p')"
done

wait $unit_tests_process
tally unit_tests $? "$scratch/unit_tests.log" "$(sed -n \
    's/^\[doctest\] test cases: *[0-9]* | *\([0-9]*\) passed | *\([0-9]*\) failed.*/\1 \2/p' "$scratch/unit_tests.log")"

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
