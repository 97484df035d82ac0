# Shared by the scripts beside it, each of which is a list of checks of the program as a user runs it:
#     . "$2/tests/cli/check.sh"             $program and $root from the script's arguments PROGRAM ROOT
#     check "a sentence" COMMAND ARGS...    passes when the command returns 0; otherwise shows its output
#     finish                                the last line: how many passed and failed
# Scripts run in an empty folder of their own.
program=$1 root=$2 checks_passed=0 checks_failed=0

check() {
    sentence=$1
    shift
    if ("$@") >check.log 2>&1; then
        checks_passed=$((checks_passed + 1))
    else
        checks_failed=$((checks_failed + 1))
        echo "FAILED: $sentence"
        echo "  $*"
        sed 's/^/  | /' check.log
    fi
}

# Runs the program with its output in the files `out` and `err`; false, with both shown, unless it ends with STATUS.
# usage: ends STATUS ARGS...
ends() {
    wanted=$1
    shift
    "$program" "$@" >out 2>err </dev/null
    status=$?
    [ $status -eq "$wanted" ] && return
    echo "exit status $status instead of $wanted; stdout and stderr:"
    cat out err
    return 1
}

# For checks of what only POSIX has: signals, devices, named pipes, limits, any byte in names. A program that ends in .exe
# is one for Windows, there or under wine(1).
# usage: on_posix COMMAND ARGS...
on_posix() { case $program in *.exe) ;; *) "$@" ;; esac; }

# The names of all methods, from the help.
methods() { "$program" help methods | sed -n 's/^  \([a-z][a-z-]*\)  .*/\1/p'; }

# For what must happen within some seconds of the clock: a busy machine may miss them once, not thrice.
# usage: in_three_tries COMMAND ARGS...
in_three_tries() { "$@" || "$@" || "$@"; }

# Are these words somewhere in the file?
# usage: says FILE TEXT
says() {
    grep -qF -e "$2" "$1" && return
    echo "'$2' is not in $1:"
    cat "$1"
    return 1
}

# usage: silent FILE
silent() {
    [ ! -s "$1" ] && return
    echo "$1 is not empty:"
    cat "$1"
    return 1
}

# usage: lines_are FILE COUNT
lines_are() {
    [ "$(wc -l <"$1")" -eq "$2" ] && return
    echo "$1 has not $2 lines:"
    cat "$1"
    return 1
}

finish() {
    echo "$checks_passed passed, $checks_failed failed"
    [ $checks_failed -eq 0 ]
}
