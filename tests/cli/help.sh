# `multipath help`: commands and topics in words, the manual, and the completion that bash can use.
. "$2/tests/cli/check.sh"

listed_commands() { "$program" --help | sed -n 's/^  \([a-z][a-z]*\)  .*/\1/p'; }
topics="scenes methods sequences numbers outputs states exit-codes"

same_help() {
    ends 0 --help && mv out wanted && ends 0 help && cmp out wanted && silent err || return
    for command in $(listed_commands); do
        ends 0 "$command" --help && mv out wanted && ends 0 help "$command" && cmp out wanted || return
    done
}
check "help and help COMMAND are what --help prints" same_help

topic_texts() {
    for topic in $topics; do
        ends 0 help "$topic" && silent err && [ -s out ] && says out . && ! awk 'length($0) > 80' out | grep . || return
        "$program" --help | tr '\n' ' ' | grep -q "[ ]$topic[,.]" || { echo "--help does not name $topic"; return 1; }
    done
}
check "every topic is named by --help and fits into 80 columns" topic_texts

known_names() {
    ends 2 solve room.obj --method x && sed -n 's/.*expected one of \(.*\), got.*/\1/p' err | tr -d , >names &&
        ends 0 help methods && for name in $(cat names); do says out "  $name " || return; done
    ends 2 solve "$root/scenes/cube.obj" -o room.x && sed -n 's/.*expected one of \([a-z., ]*\).*/\1/p' err | tr -d , >names &&
        ends 0 help outputs && for name in $(cat names); do says out "  $name " || return; done
    [ -s names ]
}
check "the topics list every method and every format that the messages list" known_names

misspelled() { ends 2 help scens && silent out && says err "got 'scens'" && says err "multipath help --help"; }
check "a misspelled topic is answered with the right one" misspelled

foreign() { ends 2 help frobnicate && silent out && says err "expected one of solve"; }
check "a foreign topic is answered with all there are" foreign

one_thing() {
    ends 2 help --man solve && says err "exclude each other" && ends 2 help --man --completion bash &&
        ends 2 help solve render && ends 2 help --completion csh && says err "expected one of bash"
}
check "help gives one thing at a time" one_thing

# Every option of every help, as the manual writes it.
manual_is_complete() {
    ends 0 help --man && silent err && mv out multipath.1 || return
    for command in $(listed_commands); do
        sed -n "/^\.SS $command\$/,/^\.S[SH] [^$command]/p" multipath.1 >section
        "$program" help "$command" | sed -n 's/^  \(-., \|    \)--\([a-z-]*\).*/\2/p' | grep -v '^help$' >options
        for option in $(sed 's/-/\\-/g' options); do
            says section "\\fB\\-\\-$option\\fR" || return
        done
    done
    for topic in SCENES METHODS SEQUENCES NUMBERS OUTPUTS STATES 'EXIT\-CODES'; do
        says multipath.1 ".SH $topic" || return
    done
}
check "the manual has every option of every command, and every topic" manual_is_complete

manual_is_valid() { groff -man -ww -Tascii multipath.1 >manual.txt 2>groff.log && silent groff.log && says manual.txt 'success: everything that was asked for'; }
command -v groff >/dev/null && check "groff has nothing to say about the manual" manual_is_valid

script() {
    ends 0 help --completion bash && silent err && mv out completion.bash || return
    ! command -v bash >/dev/null || bash -n completion.bash
}
check "the completion is a script for bash" script

# What bash offers for the last of the words.
# usage: offered WORDS...
offered() {
    bash -c '. ./completion.bash; COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)); _multipath; printf "%s\n" "${COMPREPLY[@]}"' \
        bash "$@"
}
# usage: offers "EXPECTED..." WORDS...    exactly these, in any order
offers() {
    expected=$(printf '%s\n' $1 | sort)
    shift
    found=$(offered "$@" | sort -u)
    [ "$found" = "$expected" ] && return
    echo "$*: expected" $expected, got $found
    return 1
}
completes_words() {
    offers "solve study selftest" multipath s && offers "--version" multipath --v &&
        offers "--method --memory" multipath solve --me && offers "local" multipath solve --method l &&
        offers "global" multipath solve -m gl && offers "reuse" multipath solve --method = r &&
        offers "sphere box" multipath solve --chords = && offers "scenes" multipath help sc &&
        offers "" multipath solve --lines 1
}
completes_files() {
    mkdir -p "a folder" && touch room.obj room.mtl run.state "run 2.state" table.csv || return
    offers "room.obj" multipath solve room && offers "room.mtl room.obj" multipath solve -o room &&
        offers "run.state" multipath merge run.state run. && offers "table.csv" multipath compare run.state t &&
        [ "$(offered multipath render "run ")" = "run 2.state" ] && [ "$(offered multipath paper -o "a ")" = "a folder" ]
}
options_are_complete() {
    for command in $(listed_commands); do
        offers "$("$program" help "$command" | sed -n 's/^  \(-., \|    \)\(--[a-z-]*\).*/\2/p')" multipath "$command" - || return
    done
}
if command -v bash >/dev/null; then
    check "bash completes commands, options and their choices" completes_words
    check "bash completes files with the extension that a command reads, also with blanks in their names" completes_files
    check "bash offers every option of every command" options_are_complete
fi
finish
