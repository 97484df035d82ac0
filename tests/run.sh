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

# Two parts of the unit tests, and beside them as many scripts as there are processors, those that take longest first.
jobs=$(nproc 2>/dev/null || echo 2)
run_unit_tests() { (cd "$root" && "$unit_tests" $UNIT_ARGS "$1") >"$scratch/unit_tests$1.log" 2>&1; }
case $UNIT_ARGS in *-tse=statistics*) suites=-tse=statistics ;; *) suites="-tse=statistics -ts=statistics" ;; esac
processes=
for suite in $suites; do
    run_unit_tests $suite &
    processes="$processes $!"
done
slow="tolerance solve memory page interrupt limits provenance mini selftest install study torture state"
scripts=
for name in $slow include_order_test $(ls "$root/tests/cli" | sed -n 's/\.sh$//p'); do
    case " check $LEAVE_OUT $scripts " in *" $name "*) ;; *) scripts="$scripts $name" ;; esac
done
export root program scratch
printf '%s\n' $scripts | xargs -P "$jobs" -I{} sh -c 'name=$1 script=$root/tests/cli/$1.sh
    [ -f "$script" ] || script=$root/tests/$name.sh
    mkdir "$scratch/$name" && cd "$scratch/$name" && sh "$script" "$program" "$root" >"$scratch/$name.log" 2>&1
    echo $? >"$scratch/$name.status"' run {}
for name in $scripts; do
    tally "$name.sh" "$(cat "$scratch/$name.status")" "$scratch/$name.log" "$(tail -n 1 "$scratch/$name.log" |
        sed -n 's/^\([0-9][0-9]*\) passed, \([0-9][0-9]*\) failed$/\1 \2/p')"
done

set -- $processes
for suite in $suites; do
    wait "$1"
    tally "unit_tests $suite" $? "$scratch/unit_tests$suite.log" "$(sed -n \
        's/^\[doctest\] test cases: *[0-9]* | *\([0-9]*\) passed | *\([0-9]*\) failed.*/\1 \2/p' "$scratch/unit_tests$suite.log")"
    shift
done

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
