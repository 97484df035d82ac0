# Mutation test: plants the bugs of tests/mutants.list one by one in a copy of the sources below BUILD, builds, and runs
# the unit tests without their statistics suite, those of the bug's room first, then what the list names. Tells which
# test noticed each bug, and ends with the line "N killed, N survived". Fails if a bug survives that is not marked as
# equivalent, does not compile, or is no longer found. MUTANTS chooses: those whose first line matches this pattern of
# awk. Needs BUILD/unit_tests and PROGRAM; make(1) hands on CXX and CXXFLAGS.
# With --stale builds nothing, and only tells which bugs are no longer found, or found more than once.
# usage: mutants.sh BUILD PROGRAM | --stale
case $#:$1 in 1:--stale | 2:*) ;; *) echo "usage: mutants.sh BUILD PROGRAM | --stale" >&2; exit 2 ;; esac
cd "$(dirname "$0")/.." || exit 1
LC_ALL=C
export LC_ALL

[ "$1" != --stale ] || exec awk '
    function bare(text) { sub(/^[ \t]+/, "", text); return text }
    function read_source(    text, n) {
        while ((getline text <file) > 0) line[file, ++n] = bare(text)
        close(file)
        lines[file] = n + 0
    }
    function judge(    i, k, found) {
        if (!name) return
        if (!(file in lines)) read_source()
        for (i = 1; i + olds - 1 <= lines[file]; ++i) {
            for (k = 1; k <= olds && line[file, i + k - 1] == old[k]; ++k)
                ;
            found += k > olds
        }
        if (found != 1) { print name ": found " found + 0 " times, expected once"; stale = 1 }
        ++bugs
    }
    /^[a-z]+\/[a-z0-9_\/.]+: / { judge(); name = $0; file = "src/" substr($0, 1, index($0, ":") - 1); olds = 0; next }
    /^[- ]/ { old[++olds] = bare(substr($0, 2)) }
    END { judge(); exit stale || !bugs }
    ' tests/mutants.list
build=$1 program=$2
work=$PWD/$build/mutants
copy=$work/copy list=$work/list kept=$work/kept
rm -rf "$work" && mkdir -p "$copy/$build" "$list" || exit 1

# One folder for each chosen bug: name, file, run, equivalent, change.
MUTANTS=${MUTANTS:-.} awk -v list="$list" '
    BEGIN { chosen = ENVIRON["MUTANTS"] }
    function put(what, text) { print text >> (folder "/" what); close(folder "/" what) }
    /^#/ || /^$/ { next }
    /^[a-z]+\/[a-z0-9_\/.]+: / {
        skipped = $0 !~ chosen
        if (skipped) next
        folder = sprintf("%s/%03d", list, ++count)
        system("mkdir " folder)
        put("name", $0)
        put("file", "src/" substr($0, 1, index($0, ":") - 1))
        next
    }
    skipped { next }
    /^run: / { put("run", substr($0, 6)); next }
    /^equivalent: / { put("equivalent", substr($0, 13)); next }
    /^[-+ ]/ { put("change", $0); next }
    { print "tests/mutants.list:" NR ": neither a name nor part of a change: " $0 > "/dev/stderr"; failed = 1; exit }
    END {
        if (!count && !failed) print "no bug of tests/mutants.list matches " chosen > "/dev/stderr"
        exit failed || !count
    }
    ' tests/mutants.list || exit 1

# usage: changed FOLDER     prints the file with the bug
changed() {
    awk '
        function bare(text) { sub(/^[ \t]+/, "", text); return text }
        NR == FNR {
            if (!/^\+/) old[++olds] = bare(substr($0, 2))
            if (!/^-/) new[++news] = substr($0, 2)
            next
        }
        { line[FNR] = $0; lines = FNR }
        END {
            for (i = 1; i + olds - 1 <= lines; ++i) {
                for (k = 1; k <= olds && bare(line[i + k - 1]) == old[k]; ++k)
                    ;
                if (k > olds) { ++found; at = i }
            }
            if (found != 1) { print "found " found + 0 " times, expected once"; exit 1 }
            for (i = 1; i < at; ++i) print line[i]
            for (k = 1; k <= news; ++k) print new[k]
            for (i = at + olds; i <= lines; ++i) print line[i]
        }' "$1/change" "$(cat "$1/file")"
}

failed=0
for bug in "$list"/*; do
    changed "$bug" >"$bug/changed" && continue
    echo "ERROR: $(cat "$bug/name"): $(cat "$bug/changed")"
    failed=1
done
[ $failed -eq 0 ] || exit 1

# With their times, so that nothing is compiled again. The objects that a bug changes are laid aside and come back.
cp -Rp Makefile README.md LICENSE docs scenes src tests "$copy" || exit 1
for part in src tests generated doctest doctest.path unit_tests; do
    [ ! -e "$build/$part" ] || cp -Rp "$build/$part" "$copy/$build" || exit 1
done
cp -p "$program" "$copy/$program" || exit 1

# usage: runs COMMAND...     True if it ends well, in time
runs() { (cd "$copy" && timeout "$limit" "$@" || exit) >"$work/log" 2>&1; }
# usage: script_passes NAME
script_passes() {
    rm -rf "$work/scratch" && mkdir "$work/scratch" &&
        (cd "$work/scratch" && timeout "$limit" sh "$copy/tests/cli/$1.sh" "$copy/$program" "$copy") >"$work/log" 2>&1
}
built() { (cd "$copy" && make -s --no-print-directory "$@") >"$work/log" 2>&1; }

# The first failure in the log, after what ended with the status $1.
reason() {
    if [ "$1" -eq 124 ]; then echo "the time limit"; else
        sed -n 's/^TEST CASE: *//p; s/^FAILED: //p' "$work/log" | head -n 1
    fi
}

# Builds with the bug planted, and runs tests until one fails: "killed by ...", "survived" or "ERROR: ...".
# usage: fate FOLDER
fate() {
    built "$build/unit_tests" || { echo "ERROR: does not compile"; return; }
    room=$(sed 's|src/\([a-z]*\)/.*|\1|' "$1/file")
    for filter in sf sfe; do
        runs "$build/unit_tests" -tse=statistics "-$filter=*tests/$room/*" -aa=1 ||
            { echo "killed by $(reason $?)"; return; }
    done
    for what in $(cat "$1/run" 2>/dev/null); do
        if [ "$what" = statistics ]; then
            runs "$build/unit_tests" -ts=statistics -aa=1
        else
            built "$program" && script_passes "$what"
        fi || { echo "killed by $(reason $?) ($what)"; return; }
    done
    if [ -e "$1/equivalent" ]; then echo "equivalent: $(cat "$1/equivalent")"; else echo survived; fi
}

limit=3600
start=$(date +%s)
built "$build/unit_tests" "$program" && runs "$build/unit_tests" -tse=statistics ||
    { tail -n 20 "$work/log"; echo "ERROR: without a bug the unit tests do not pass"; exit 1; }
limit=$((60 + 3 * ($(date +%s) - start))) # of each run with a bug

killed=0 survived=0
for bug in "$list"/*; do
    file=$(cat "$bug/file")
    objects=$(cd "$copy" && find "$build" -name '*.d' -exec grep -lF "$file" {} + | sed 's/d$/o/')
    (cd "$copy" && cp -p "$file" "$work/source" && for object in $objects; do
        mkdir -p "$kept/$(dirname "$object")" && mv "$object" "$kept/$object" || exit
    done) && cp "$bug/changed" "$copy/$file" || exit 1
    told=$(fate "$bug")
    echo "$(cat "$bug/name"): $told"
    case $told in
    killed*) killed=$((killed + 1)) ;;
    survived) survived=$((survived + 1)) ;;
    ERROR*) failed=1; head -n 5 "$work/log" ;;
    esac
    (cd "$copy" && cp -p "$work/source" "$file" && for object in $objects; do
        mv "$kept/$object" "$object" || exit
    done) || exit 1
done
echo "$killed killed, $survived survived"
[ $failed -eq 0 ] && [ $survived -eq 0 ]
