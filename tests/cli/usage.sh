# The exit codes and messages that every command shares: 1 when the input or the work failed, 2 for wrong usage.
. "$2/tests/cli/check.sh"

no_arguments() { ends 2 && silent out && says err usage && says err solve; }
check "without arguments the usage goes to stderr and the exit code is 2" no_arguments

program_help() {
    ends 0 --help && silent err && says out usage && says out "  solve "
}
check "--help lists the commands on stdout" program_help

version() {
    ends 0 --version && silent err && says out multipath && grep -q '[0-9]\.[0-9]' out &&
        grep -qiE 'gcc|g\+\+|clang' out
}
check "--version names the program's version and the compiler" version

kernel_limit() {
    MULTIPATH_KERNELS=plain && export MULTIPATH_KERNELS && ends 0 --version && says out "instruction sets: plain" || return
    MULTIPATH_KERNELS=sse9 && ends 2 --version && silent out && says err "MULTIPATH_KERNELS: expected one of "
}
check "the instruction sets can be limited, and a limit that is none is refused" kernel_limit
unset MULTIPATH_KERNELS

listed_commands() { "$program" --help | sed -n 's/^  \([a-z][a-z]*\)  .*/\1/p'; }
command_help() {
    [ "$(listed_commands)" ] || return
    for command in $(listed_commands); do
        ends 0 "$command" --help && silent err && says out "usage: multipath $command" || return
    done
}
check "every command that --help lists has its own help" command_help

solve_options() {
    ends 0 solve --help || return
    for option in output json quiet method bidirectional line-order chords lines ratio power-per-line threshold steps estimator sequence pairing skip seed threads patch-size patches two-sided flip \
        state save-every resume from-state shard show size help; do
        grep -qE -- "^  (-.,|   ) --$option( |$)" out || { echo "--$option is missing:"; cat out; return 1; }
    done
}
check "solve --help lists the options of the manual" solve_options

narrow_help() {
    for command in $(listed_commands); do
        ends 0 $command --help && ! awk 'length($0) > 80' out | grep . || return
    done
}
check "the help fits into 80 columns" narrow_help

unknown_command() { ends 2 sovle && silent out && says err "expected one of solve"; }
check "a misspelled command is answered with the list of all" unknown_command

unknown_option() {
    ends 2 solve "$root/scenes/5cubes.obj" --line 5 && says err "unknown option '--line'; did you mean --lines?" &&
        says err "multipath solve --help"
}
check "a misspelled option is answered with the way to the help" unknown_option

# Each is wrong whatever the scene, and found before the scene is read.
# usage: refused TEXT ARGS...
refused() {
    text=$1
    shift
    ends 2 solve "$root/scenes/5cubes.obj" "$@" && silent out && says err "$text"
}
check "a number that is none is refused" refused "--lines: expected a count" --lines ten
check "a decimal comma is refused" refused "--lines: expected a count" --lines 1,5
check "an unknown method is refused" refused "got 'globl'" --method globl
check "a value that is missing is asked for" refused "--lines needs a value" --lines
check "an option given twice is refused" refused "--lines is given twice" --lines 5 --lines 6
check "an error to show needs more than one run" refused "expected --replicates" --show error
check "and the refusal names the other way to have it" refused "--tolerance" --show error --replicates 1
check "an error to stop at needs more than one run" refused "--replicates: --tolerance and --time need at least 2" --tolerance 1% --replicates 1
check "replicates of a sequence without a random form are refused" refused "--sequence: hammersley has no randomised form" \
    --sequence hammersley:5000 --replicates 2
check "a quantity that is none is refused" refused "got 'eror'" --show eror
check "false colours are not exposed" refused "--exposure has no effect with --show irradiance" --show irradiance --exposure 1
check "nor interpolated" refused "--shading has no effect with --show patches" --show patches --shading smooth
check "a flag with a value is refused" refused "--quiet takes no value" --quiet=yes
check "an unknown output extension is refused" refused room.xyz -o room.xyz
check "an output without extension is refused" refused "'room'" -o room
check "a second scene is refused" refused b.obj b.obj

no_scene() { ends 2 solve --lines 100 && says err "missing SCENE.obj"; }
check "solve without a scene says what is missing" no_scene

missing_scene() { ends 1 solve none.obj --lines 100 && silent out && lines_are err 1 && says err none.obj; }
check "a scene that does not exist is one line on stderr and exit code 1" missing_scene

# With so many lines the solver would not return while the tests run.
missing_folder() {
    ends 1 solve "$root/scenes/5cubes.obj" --lines 2^40 -o good.png -o none/room.png && silent out &&
        says err "cannot write none/room.png: No such file or directory" || return
    [ -z "$(find . -name '*good*')" ] || { echo "the other output has left a file:"; ls -A; return 1; }
}
check "an output in a missing folder is reported before solving, and no other output is begun" missing_folder
# A terminal would take them for commands.
no_controls() {
    strange=$(printf 'red\033[31m') && mkdir "$strange" && cp "$root"/scenes/cube.* "$strange" || return
    ends 1 check "$strange/none.obj" && says err 'red?[31m/none.obj' || return
    ends 0 check "$strange/cube.obj" && says out 'red?[31m/cube.obj' || return
    ends 0 solve "$strange/cube.obj" --lines 1000 --patches 100 -o "$strange/a.csv" && says err 'red?[31m/a.csv' || return
    ends 2 "$strange" && says err 'red?[31m'
}
on_posix check "control characters in names do not reach the terminal" no_controls
finish
