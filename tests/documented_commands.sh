# Runs the commands of the documents as they are written: the `sh` blocks of docs/*.md, those of one document in order and in one
# folder, which holds the program, the scenes and the tests and nothing else. What needs other machines or many minutes stands in
# `console` blocks; a command in a block of no kind is a mistake. Pictures of the text that its commands make must come out as they
# are, byte for byte but for the record of the command. Ends with "N passed, N failed".
# usage: documented_commands.sh PROGRAM [DOCUMENT...]
# BUILD: where to work; TIME_LIMIT: seconds for each block; RENEW=yes: pictures take the place of those checked in
[ $# -ge 1 ] || { echo "usage: documented_commands.sh PROGRAM [DOCUMENT...]" >&2; exit 2; }
absolute() { echo "$(cd "$(dirname "$1")" && pwd)/$(basename "$1")"; }
root=$(cd "$(dirname "$0")/.." && pwd) || exit 1
program=$(absolute "$1")
shift
[ $# -gt 0 ] || set -- "$root"/docs/*.md
scratch=$(absolute "${BUILD:-$root/build}")/documented-commands
rm -rf "$scratch" && mkdir -p "$scratch" || exit 1
passed=0 failed=0 here=$PWD

# usage: fail WHAT [LOG]
fail() {
    failed=$((failed + 1))
    echo "FAILED: $1"
    [ $# -eq 1 ] || sed 's/^/  | /' "$2"
}

# Writes each `sh` block to the file block-LINE.sh, and prints the lines of commands in blocks of no kind.
# usage: blocks_of DOCUMENT
blocks_of() {
    awk '/^```/ { inside = !inside; kind = substr($0, 4); file = sprintf("block-%04d.sh", NR); next }
         inside && kind == "sh" { print > file }
         inside && kind == "" && /^(\.\/)?multipath |^make / { print NR }' "$1"
}

# The record names all options, so it changes whenever the program learns one.
without_record() { LC_ALL=C tr '\n' ' ' <"$1" | LC_ALL=C sed -e 's/....tEXt.*IDAT/IDAT/' -e 's/command: multipath[^<]*//' | cksum; }

# usage: compare_pictures DOCUMENT      in the folder where its commands ran
compare_pictures() {
    for picture in $(sed -n 's/.*!\[[^]]*\](\([^)]*\)).*/\1/p' "$1"); do
        made=docs/$picture checked_in=$(dirname "$1")/$picture
        [ -e "$made" ] || made=$(basename "$picture")
        [ -e "$made" ] || continue
        [ "$RENEW" = yes ] && cp "$made" "$checked_in"
        if [ "$(without_record "$made")" = "$(without_record "$checked_in")" ]; then
            passed=$((passed + 1))
        else
            fail "$picture in $(basename "$1") is not what the command beside it makes; 'make pictures' renews it"
        fi
    done
}

for document in "$@"; do
    cd "$here" && document=$(absolute "$document")
    name=$(basename "$document")
    mkdir "$scratch/$name" && cd "$scratch/$name" || exit 1
    mkdir -p docs/gallery docs/readme && cp -r "$root/scenes" . && ln -s "$root/tests" tests && ln -s "$program" multipath || exit 1
    for line in $(blocks_of "$document"); do
        fail "$name:$line: a command in a block of no kind; expected sh, or console for what is not to be run"
    done
    for block in block-*.sh; do
        [ -e "$block" ] || continue
        if timeout "${TIME_LIMIT:-300}" sh -ex "./$block" >"$block.log" 2>&1 </dev/null; then
            passed=$((passed + 1))
        else
            line=${block#block-}
            fail "$name: the commands from line $((1${line%.sh} - 10000))" "$block.log"
        fi
    done
    compare_pictures "$document"
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
