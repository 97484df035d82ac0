# Which lines of src/ the tests run: builds with counters in BUILD/coverage, runs the tests, and prints a table of the folders,
# the files below 95 % with the lines that none ran, and last the line "total N of M lines, P %". It fails if P is below 95.
# A line that is compiled more than once, as those of headers and of kernels for several instruction sets, counts once,
# and as covered if any of them ran. UNIT_ARGS and LEAVE_OUT choose tests as in run.sh; if they
# are not set, tests are left out that take long and reach no further line. CXX must be a g++.
# usage: coverage.sh
[ $# -eq 0 ] || { echo "usage: coverage.sh" >&2; exit 2; }
cd "$(dirname "$0")/.." || exit 1
counted=${BUILD:-build}/coverage
UNIT_ARGS=${UNIT_ARGS--tse=statistics} LEAVE_OUT=${LEAVE_OUT-torture} LC_ALL=C
export UNIT_ARGS LEAVE_OUT LC_ALL
# Counters that a former run has left would be added to.
mkdir -p $counted && find $counted -name '*.gcda' -exec rm {} + || exit 1
make --no-print-directory CXX="${CXX:-g++}" CXXFLAGS="-O1 --coverage" BUILD=$counted $counted/multipath $counted/unit_tests || exit 1
sh tests/run.sh $counted/unit_tests $counted/multipath $counted || exit 1

# One line "FILE NUMBER COUNT" for each that holds code, once for each object that it went into; without those of libraries.
counts() {
    find src tests -name '*.cpp' | sed "s|\(.*\)cpp$|$counted/\1gcno|" | xargs ls 2>/dev/null |
        xargs gcov --stdout --relative-only 2>$counted/gcov.log | awk -F: '
        $3 == "Source" { file = $4; next }
        file ~ /^src\// && $2 + 0 > 0 && $1 !~ /- *$/ { print file, $2 + 0, $1 ~ /[0-9]/ }'
}

counts | sort -u -k1,1 -k2,2n -k3,3nr | sort -u -k1,1 -k2,2n -s | awk -v least=95 '
    function percent(covered, lines) { return int(1000 * covered / lines) / 10 } # 95.0 is never less than 95
    function end_gap() {
        if (first) gaps = gaps (gaps ? ", " : "") (first == last ? first : first "-" last)
        first = 0
    }
    function end_file() {
        end_gap()
        if (file && percent(file_covered, file_lines) < least)
            below = below sprintf("%s: %.1f %%, not %s\n", file, percent(file_covered, file_lines), gaps)
        file_lines = file_covered = 0
        gaps = ""
    }
    $1 != file { end_file(); file = $1 }
    {
        folder = file ~ /\/.*\// ? file : "main.cpp"
        gsub(/^src\/|\/.*/, "", folder)
        lines[folder]++; file_lines++; total++
        if ($3) { covered[folder]++; file_covered++; total_covered++; end_gap() } else { if (!first) first = $2; last = $2 }
    }
    END {
        end_file()
        if (!total) { print "gcov found no line of src/" > "/dev/stderr"; exit 1 }
        printf "%-12s %7s %8s %9s\n", "folder", "lines", "covered", "percent"
        fflush()
        for (folder in lines)
            printf "%-12s %7d %8d %7.1f %%\n", folder, lines[folder], covered[folder], percent(covered[folder], lines[folder]) | "sort"
        close("sort")
        printf "%s", below
        printf "total %d of %d lines, %.1f %%\n", total_covered, total, percent(total_covered, total)
        exit percent(total_covered, total) < least
    }'
