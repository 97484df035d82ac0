# Messages of the layers below `commands` and `cli` state facts; only the commands know options. So no string there has the name
# of one, such as --lines.
# usage: option_names_test.sh PROGRAM ROOT, in a folder of its own
. "$2/tests/cli/check.sh"

options=$("$program" help --man | sed -n 's/\\-/-/g; s/^  \(-., \|    \)\(--[a-z-]*\).*/\2/p' | sort -u)

# Prints "FILE:LINE: names --OPTION" for every option in a string literal, raw or not, of the layers below; false if there is one.
# usage: no_options SRC
no_options() {
    find "$1" -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.inl' \) ! -path "$1/commands/*" ! -path "$1/cli/*" \
        ! -path "$1/main.cpp" -exec awk -v options="$(echo $options)" '
        BEGIN { split(options, list, " "); for (k in list) is_option[list[k]] }
        FNR == 1 { raw = 0 }
        {
            rest = $0
            gsub(/[0-9]\047[0-9]/, "00", rest) # as in 10 000 with a separator
            strings = ""
            while (rest != "")
                if (raw) {
                    end = index(rest, raw_end)
                    raw = !end
                    strings = strings " " (raw ? rest : substr(rest, 1, end - 1))
                    rest = raw ? "" : substr(rest, end + length(raw_end))
                } else if (match(rest, /\/\/|R"[a-z]*\(|["\047]/)) {
                    start = substr(rest, RSTART, RLENGTH)
                    rest = start == "//" ? "" : substr(rest, RSTART + RLENGTH)
                    raw = start ~ /^R/
                    raw_end = ")" substr(start, 3, length(start) - 3) "\""
                    if (raw || rest == "")
                        continue
                    match(rest, start == "\"" ? "^([^\"\\\\]|\\\\.)*" : "^([^\047\\\\]|\\\\.)*")
                    if (start == "\"")
                        strings = strings " " substr(rest, 1, RLENGTH)
                    rest = substr(rest, RLENGTH + 2)
                } else
                    rest = ""
            for (; match(strings, /--[a-z][a-z-]*/); strings = substr(strings, RSTART + RLENGTH))
                if (substr(strings, RSTART, RLENGTH) in is_option)
                    print FILENAME ":" FNR ": names " substr(strings, RSTART, RLENGTH)
        }' {} + | sort >found
    [ ! -s found ] || { cat found; return 1; }
}
check "no string of the lower layers names an option" no_options "$root/src"

# A tree with one file.
# usage: allowed FILE LINE...
allowed() {
    rm -rf tree && mkdir -p "tree/$(dirname "$1")" && file=$1 && shift && printf '%s\n' "$@" >"tree/$file" && no_options tree
}
# usage: found_in_line NUMBER OPTION FILE LINE...
found_in_line() {
    wanted="tree/$3:$1: names $2"
    shift 2
    ! allowed "$@" && [ "$(cat found)" = "$wanted" ]
}
check "an option in a message is found" found_in_line 2 --lines study/curve.cpp 'void f();' 'throw InputError("expected more --lines");'
check "and so is one with dashes, before a colon" found_in_line 1 --patch-size scene/scene.h 'return "--patch-size: too small";'
check "after other strings and characters" found_in_line 1 --flip check/a.cpp "f('\"', \"a\\\"\", '\\'', 10'000, \"(--flip turns\"); // why"
check "in a raw string" found_in_line 3 --two-sided study/a.cpp 'const char* a = R"(one' 'two "' 'three --two-sided)";'
check "and after it" found_in_line 2 --two-sided study/a.cpp 'f(R"html(one)"' 'two)html", "--two-sided");'
check "commands name options" allowed commands/solve/a.cpp 'return "--lines";'
check "and so does the command line" allowed cli/a.cpp 'return "--lines";'
check "and main.cpp" allowed main.cpp 'return "--version";'
check "comments may name options" allowed study/a.cpp 'f("a"); // as "--lines" names it'
check "decrements are no options" allowed study/a.cpp 'f("a", --lines, "b");'
check "variables of CSS are no options" allowed study/a.cpp 'f("color: var(--ink)");'
finish
