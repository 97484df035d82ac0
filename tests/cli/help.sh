# `multipath help`: commands and topics in words, and the manual.
. "$2/tests/cli/check.sh"

listed_commands() { "$program" --help | sed -n 's/^  \([a-z][a-z]*\)  .*/\1/p'; }
topics="scenes methods sequences outputs states exit-codes"

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

foreign() { ends 2 help frobnicate && silent out && says err "expected one of scenes"; }
check "a foreign topic is answered with all there are" foreign

one_thing() { ends 2 help --man solve && says err "exclude each other" && ends 2 help solve render; }
check "help gives one thing at a time" one_thing

# Every option of every help, as the manual writes it.
manual_is_complete() {
    ends 0 help --man && silent err && mv out multipath.1 || return
    for command in $(listed_commands); do
        sed -n "/^\.SS $command\$/,/^\.fi/p" multipath.1 >section
        "$program" help "$command" | sed -n 's/^  \(-., \|    \)--\([a-z-]*\).*/\2/p' >options
        for option in $(sed 's/-/\\-/g' options); do
            says section "\\-\\-$option" || return
        done
    done
    for topic in $(echo $topics | sed 's/-/\\-/g'); do
        says multipath.1 ".SS $topic" || return
    done
}
check "the manual has every option of every command, and every topic" manual_is_complete

manual_is_valid() { groff -man -ww -Tascii multipath.1 >manual.txt 2>groff.log && silent groff.log && says manual.txt 'success: everything that was asked for'; }
command -v groff >/dev/null && check "groff has nothing to say about the manual" manual_is_valid

finish
