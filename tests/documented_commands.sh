# Runs the commands of the documents as they are written: the `sh` blocks of docs/*.md, docs/*.html and docs/builders/*.md, those of
# one document in order and in one folder, which holds the program, the scenes and the tests and nothing else. What needs other
# machines or many minutes stands in `console` blocks; a command in a block of no kind is a mistake. Pictures of the text that its
# commands make must come out as they are, byte for byte but for the record of the command. Ends with "N passed, N failed".
#
# Numbers in the text are those that the commands print. Comments below a block, one for each, which readers do not see, say which:
#     <!-- prints: says that # particles take <- ... # particles -->
#     <!-- prints: error is # instead of # <- relative # ... relative # ± 2 % -->
# Left of the arrow stand words of the document with # for each number; they must occur there once. On the right stand words of what
# the block has printed, "+ COMMAND" lines (of sh -x) included, with # for each of the same numbers and "..." for as little as
# possible of anything else. Blanks and line ends are alike. A number agrees if it is what was printed, rounded to the digits that the
# text has, or is off by no more than the tolerance at the end, for what is random. A block that is for numbers alone is hidden:
#     <!-- sh
#     ./multipath solve scenes/5cubes.obj --bidirectional no -q -o one-way.csv
#     ./multipath compare one-way.csv truth.csv | sed -n "s/^MSE/one way:/p"
#     -->
# What filters print stands in its output once; what `echo` prints stands in the "+ echo" line as well. The "+" lines of the
# commands of one pipeline may be mixed word by word: numbers are found in what pipelines print, not in their commands.
# RENEW=yes puts what was printed into the text and tells what it changed: read those sentences again.
#
# usage: documented_commands.sh PROGRAM [DOCUMENT...]
# BUILD: where to work; TIME_LIMIT: seconds for each block; RENEW=yes: pictures and numbers take the place of those checked in
[ $# -ge 1 ] || { echo "usage: documented_commands.sh PROGRAM [DOCUMENT...]" >&2; exit 2; }
absolute() { echo "$(cd "$(dirname "$1")" && pwd)/$(basename "$1")"; }
root=$(cd "$(dirname "$0")/.." && pwd) || exit 1
program=$(absolute "$1")
shift
[ $# -gt 0 ] || set -- "$root"/docs/*.md "$root"/docs/*.html "$root"/docs/builders/*.md
scratch=$(absolute "${BUILD:-$root/build}")/documented-commands
rm -rf "$scratch" && mkdir -p "$scratch" || exit 1
passed=0 failed=0 here=$PWD

# usage: fail WHAT [LOG]
fail() {
    failed=$((failed + 1))
    echo "FAILED: $1"
    [ $# -eq 1 ] || sed 's/^/  | /' "$2"
}

# Writes each `sh` block to the file block-LINE.sh and the numbers that it prints to block-LINE.numbers. Prints the numbers of
# lines that are mistakes, and what is wrong with them.
# usage: blocks_of DOCUMENT
blocks_of() {
    awk 'function begin(what) { kind = what; if (kind == "sh") file = sprintf("block-%04d", NR) }
         /^<!-- sh$/ && !inside { hidden = inside = 1; begin("sh"); next }
         hidden && /^-->$/ { hidden = inside = 0; next }
         /^```/ && !hidden { inside = !inside; if (inside) begin(substr($0, 4)); next }
         inside && kind == "sh" { print > (file ".sh") }
         inside && kind == "" && /^(\.\/)?multipath |^make / {
             print NR ": a command in a block of no kind; expected sh, or console for what is not to be run" }
         /^<!-- prints:/ && !inside {
             if (!file || !/^<!-- prints: .*[^ ] <- [^ ].* -->$/)
                 print NR ": expected <!-- prints: TEXT <- OUTPUT --> below a block of commands"
             else
                 print substr($0, 14, length - 17) > (file ".numbers") }
         END { if (hidden) print NR ": expected --> after the hidden commands" }' "$1"
}

# Compares the numbers of a document with those that a block printed. Prints a line for each that differs, or was renewed, and in
# the last line how many agree and how many do not.
# usage: compare_numbers DOCUMENT NUMBERS LOG
compare_numbers() {
    LC_ALL=C awk -v renew="$RENEW" '
    function text_of(file,   line, text) {
        while ((getline line < file) > 0)
            text = text line "\n"
        close(file)
        return text
    }
    function regex_of(words,   k, c, regex) {
        gsub(/[ \t\n]+/, " ", words)
        for (k = 1; k <= length(words); ++k) {
            c = substr(words, k, 1)
            regex = regex (c == "#" ? number : c == " " ? "[ \t\n]+" : index("\\^$.[]|()+?{}*", c) ? "\\" c : c)
        }
        return regex
    }
    # Where the words are in the text from a place on: sets found[n] and place[n] for the numbers n = count + 1 ... Returns the
    # place behind them, 0 if they are not there.
    function find(words, text, from,   literal, k, rest, pieces) {
        rest = substr(text, from)
        if (!match(rest, regex_of(words)))
            return 0
        from += RSTART - 1
        pieces = split(words, literal, "#")
        for (k = 1; k <= pieces; ++k) {
            match(substr(text, from), "^" regex_of(literal[k]))
            from += literal[k] == "" ? 0 : RLENGTH
            if (k < pieces) {
                match(substr(text, from), "^" number)
                place[++count] = from
                found[count] = substr(text, from, RLENGTH)
                from += RLENGTH
            }
        }
        return from
    }
    function value_of(written) {
        gsub(/,/, "", written)
        sub(minus, "-", written)
        return written + 0
    }
    function decimals_of(written) {
        sub(/e.*/, "", written)
        return written ~ /\./ ? length(written) - index(written, ".") : 0
    }
    function unit_of(written,   exponent) { # of its last digit
        exponent = written
        if (!sub(/.*e/, "", exponent))
            exponent = 0
        return 10 ^ (exponent - decimals_of(written))
    }
    function as_written(value, like,   text, whole) {
        text = sprintf("%." decimals_of(like) (like ~ /e/ ? "e" : "f"), value)
        sub(/e\+?0*/, "e", text)
        sub(/e-0*/, "e-", text)
        if (like ~ /,/) {
            whole = text
            sub(/\..*/, "", whole)
            text = substr(text, length(whole) + 1)
            while (whole ~ /[0-9][0-9][0-9][0-9]/) {
                text = "," substr(whole, length(whole) - 2) text
                whole = substr(whole, 1, length(whole) - 3)
            }
            text = whole text
        }
        if (index(like, minus))
            sub(/^-/, minus, text)
        return text
    }
    function differs(what) { print "\"" words "\": " what; ++failed }
    BEGIN {
        minus = "\342\210\222"
        number = "(-|" minus ")?[0-9]+(,[0-9][0-9][0-9])*(\\.[0-9]+)?(e[-+]?[0-9]+)?"
        document = text_of(ARGV[1])
        log_text = text_of(ARGV[3])
        while ((getline line < ARGV[2]) > 0) {
            tolerance = 0
            if (match(line, / \302\261 [0-9.]+ %$/)) {
                tolerance = substr(line, RSTART + 4, RLENGTH - 6) / 100
                line = substr(line, 1, RSTART - 1)
            }
            words = substr(line, 1, index(line, " <- ") - 1)
            output = substr(line, index(line, " <- ") + 4)
            count = 0
            end = find(words, document, 1)
            written = count
            if (!end || find(words, document, end)) {
                differs("the document has this " (end ? "twice" : "nowhere"))
                continue
            }
            count = written
            pieces = split(output, piece, "[.][.][.]")
            end = 1
            for (k = 1; k <= pieces && end; ++k) {
                gsub(/^ +| +$/, "", piece[k])
                if (piece[k] != "")
                    end = find(piece[k], log_text, end)
            }
            if (!end || !written || count != 2 * written) {
                differs(end ? written " numbers, and " (count - written) " in \"" output "\"" : "not printed: \"" output "\"")
                continue
            }
            for (k = written; k >= 1; --k) {
                value = value_of(found[written + k])
                off = value_of(found[k]) - value
                off = off < 0 ? -off : off
                if (off <= (0.5 + 1e-6) * unit_of(found[k]) || off <= tolerance * (value < 0 ? -value : value))
                    ++passed
                else if (renew != "yes")
                    differs(found[k] " should be " as_written(value, found[k]) ", as printed: " found[written + k])
                else {
                    renewed = as_written(value, found[k])
                    document = substr(document, 1, place[k] - 1) renewed substr(document, place[k] + length(found[k]))
                    print "\"" words "\": " found[k] " is now " renewed
                    ++passed
                }
            }
        }
        if (renewed)
            printf "%s", document > ARGV[1]
        print passed + 0, failed + 0
        exit
    }' "$@"
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
    blocks_of "$document" >block-mistakes
    while read -r mistake; do
        fail "$name:$mistake"
    done <block-mistakes
    for block in block-*.sh; do
        [ -e "$block" ] || continue
        line=${block#block-} block=${block%.sh}
        line=$((1${line%.sh} - 10000))
        if timeout "${TIME_LIMIT:-300}" sh -ex "./$block.sh" >"$block.log" 2>&1 </dev/null; then
            passed=$((passed + 1))
        else
            fail "$name: the commands from line $line" "$block.log"
        fi
        [ -e "$block.numbers" ] || continue
        compare_numbers "$document" "$block.numbers" "$block.log" >"$block.differences" || fail "$name: numbers below line $line"
        sed "\$d; s/^/$name:$line: /" "$block.differences"
        read -r agree differ <<END
$(tail -n 1 "$block.differences")
END
        passed=$((passed + agree)) failed=$((failed + differ))
    done
    compare_pictures "$document"
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
