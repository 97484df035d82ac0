# Runs the tests, shows what failed, and ends with the line "N passed, N failed". `long` are those that take long, the unit
# tests of the suite `statistics` and some scripts; `quick` are all others.
# LEAVE_OUT names scripts to leave out, and UNIT_ARGS are for the unit tests; where UNIT_TESTS is none, only the scripts run.
# usage: run.sh UNIT_TESTS PROGRAM BUILD [quick|long]
case $#:$4 in 3: | 4:quick | 4:long) ;; *) echo "usage: run.sh UNIT_TESTS PROGRAM BUILD [quick|long]" >&2; exit 2 ;; esac
absolute() { echo "$(cd "$(dirname "$1")" && pwd)/$(basename "$1")"; }
root=$(cd "$(dirname "$0")/.." && pwd) || exit 1
[ "$1" = none ] && unit_tests=none || unit_tests=$(absolute "$1")
program=$(absolute "$2")
scratch=$(absolute "$3")/test-run${4:+-$4}
rm -rf "$scratch" && mkdir -p "$scratch" || exit 1
LC_ALL=C
export LC_ALL

# Programs for Windows run under wine(1) elsewhere. Copies of the script that does so stand for the program: where it is
# called, its name ends in .exe, too. What stops them by POSIX signals is left out.
case $program:$OS in
*.exe:Windows_NT) ;;
*.exe:*)
    command -v wine >/dev/null || { echo "tests: wine is missing: install the package wine" >&2; exit 2; }
    for file in "$program" "$unit_tests"; do
        printf '#!/bin/sh\nWINEDEBUG=-all exec wine "%s" "$@"\n' "$file" >"$scratch/$(basename "$file")"
        chmod +x "$scratch/$(basename "$file")"
    done
    program=$scratch/$(basename "$program")
    [ "$unit_tests" = none ] || unit_tests=$scratch/$(basename "$unit_tests")
    ;;
esac
case $program in *.exe) LEAVE_OUT="$LEAVE_OUT interrupt memory" ;; esac

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

# The unit tests, and beside them as many scripts as there are processors, those that take longest first.
jobs=$(nproc 2>/dev/null || echo 2)
run_unit_tests() { (cd "$root" && "$unit_tests" $UNIT_ARGS "$1") >"$scratch/unit_tests$1.log" 2>&1; }
case $4:$UNIT_ARGS:$unit_tests in
*:none) suites= ;;
long:*) suites=-ts=statistics ;;
quick:* | *-tse=statistics*) suites=-tse=statistics ;;
*) suites="-tse=statistics -ts=statistics" ;;
esac
processes=
for suite in $suites; do
    run_unit_tests $suite &
    processes="$processes $!"
done
long="limits tolerance memory interrupt page install mini selftest"
all="$long solve torture state study provenance compare include_order_test option_names_test elementary_test $(ls "$root/tests/cli" | sed -n 's/\.sh$//p')"
case $4 in
long) wanted=$long ;;
quick) wanted=$all LEAVE_OUT="$LEAVE_OUT $long" ;;
*) wanted=$all ;;
esac
scripts=
for name in $wanted; do
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
