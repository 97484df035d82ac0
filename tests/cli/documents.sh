# What keeps the documents true: tests/documented_commands.sh, with a program that prints known numbers.
. "$2/tests/cli/check.sh"

cat >prints <<'END'
#!/bin/sh
echo "12,345 particles take $1 lines"
echo "MSE 0.001 W2/m4    relative 4.567e-04
slope -1.064, and 70.2 W"
END
chmod +x prints

# usage: documents_end STATUS DOCUMENT      with their output in `out`
documents_end() {
    BUILD=$PWD sh "$root/tests/documented_commands.sh" prints "$2" >out 2>&1
    status=$?
    [ $status -eq "$1" ] || { echo "exit status $status instead of $1"; cat out; return 1; }
}

cat >right.md <<'END'
The head says that 12,345 particles take
10,000 lines. The error is 4.6e-4 instead of 2.3e-2; the slope is −1.06, and about 69 W are left. Hidden: 42 (a * b).
```sh
./multipath 10000
./multipath 20000
echo 'relative 0.0231'
```
<!-- prints: says that # particles take 10,000 lines <- # particles -->
<!-- prints: error is # instead of # <- multipath 20000 ... relative # ... relative # -->
<!-- prints: the slope is # <- slope # -->
<!-- prints: about # W are left <- and # W ± 2 % -->
<!-- sh
echo forty-two = 42
-->
<!-- prints: Hidden: # (a * b). <- forty-two = # -->
END

agree() { documents_end 0 right.md && says out "8 passed, 0 failed" && lines_are out 1; }
check "numbers that the commands print are found in the text, rounded as it has them" agree

# usage: wrong FROM TO MESSAGE      the document with FROM replaced fails, and the message says what was printed
wrong() {
    sed "s/$1/$2/" right.md >wrong.md && ! cmp -s right.md wrong.md || { echo "nothing to replace"; return 1; }
    documents_end 1 wrong.md && says out "$3" && says out "1 failed"
}
check "a wrong count is told" wrong "that 12,345" "that 12,344" "12,344 should be 12,345, as printed: 12,345"
check "a wrong last digit is told" wrong "4.6e-4" "4.5e-4" "4.5e-4 should be 4.6e-4, as printed: 4.567e-04"
check "one of two numbers that is wrong is told" wrong "2.3e-2" "2.2e-2" "2.2e-2 should be 2.3e-2"
check "a wrong sign is told" wrong "−1.06" "1.06" "1.06 should be -1.06"
check "a number outside its tolerance is told" wrong "about 69" "about 68" "68 should be 70"
check "a wrong number below hidden commands is told" wrong "Hidden: 42" "Hidden: 43" "43 should be 42"
check "a sentence that is gone is told" wrong "The error is" "The mistake is" "the document has this nowhere"
check "an ambiguous sentence is told" wrong "^The head" "As the slope is 2, the head" "the document has this twice"
check "what is not printed any more is told" wrong "<- slope" "<- steepness" 'not printed: "steepness #"'
check "a comment without an arrow is a mistake" wrong "is # <- slope #" "is #" "expected <!-- prints: TEXT <- OUTPUT -->"
check "so is a number that nothing is compared with" wrong "<- slope #" "<- slope" '1 numbers, and 0 in "slope"'

renewed() {
    sed 's/12,345/9,999/; s/4.6e-4/1.0e-3/; s/2.3e-2/7.1e-2/; s/−1.06/−2.00/' right.md >old.md
    RENEW=yes documents_end 0 old.md && cmp old.md right.md && says out "9,999 is now 12,345" && says out "−2.00 is now −1.06"
}
check "RENEW=yes puts what was printed into the text" renewed

# Pictures and tables of the README are made to be looked at: one that another command overwrites is lost.
written_once() {
    sed -n '/^```sh$/,/^```$/p' "$root/README.md" | grep -oE ' (-o|--output|--state) [^ ]+' | sort | uniq -d >twice
    silent twice
}
check "no two commands of the README write the same file" written_once

# The bugs to plant are of the sources as they are.
planted() {
    sh "$root/tests/mutants.sh" --stale || return
    mkdir -p copy/tests copy/src/image && cp "$root/tests/mutants.sh" copy/tests && printf 'image/a.cpp: twice\n-one\n\nimage/a.cpp: once\n+more\n-two\n' >copy/tests/mutants.list &&
        printf '  one\ntwo\none\n' >copy/src/image/a.cpp && sh copy/tests/mutants.sh --stale >out && return 1
    [ "$(cat out)" = "image/a.cpp: twice: found 2 times, expected once" ]
}
check "every bug of the list of mutants is found once in its file" planted
finish
