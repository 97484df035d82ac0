# `multipath points`: sequences as tables and drawings, and how even they are.
. "$2/tests/cli/check.sh"

table() {
    ends 0 points --dims 4 --count 10 && silent err && lines_are out 14 && says out "n,x0,x1,x2,x3" &&
        says out "# command: multipath points --dims 4 --count 10" && says out "# seed: 1" &&
        says out "3,0.75,0.25,0.75,0.75"
}
check "without -o the points go to stdout as CSV, with where they come from" table

again() {
    ends 0 points --sequence random --dims 3 --seed 7 --skip 5 --count 20 && mv out first || return
    command=$(sed -n 's/^# command: multipath //p' first)
    ends 0 $command && cmp out first && ends 0 points --sequence random --dims 3 --seed 8 --skip 5 --count 20 &&
        ! cmp -s out first
}
check "the command in the comments makes the same table again; another seed does not" again

skipped() {
    ends 0 points --sequence halton --skip 6 --count 4 && grep -v '^#' out | tail -n 4 >tail &&
        ends 0 points --sequence halton --count 10 && grep -v '^#' out | tail -n 4 | cmp - tail
}
check "--skip leaves out the first points and no others" skipped

files() {
    ends 0 points --dims 4 --count 100 -o points.csv -o points.svg && silent out && says points.csv "99," &&
        says points.svg "</svg>" && says points.svg "multipath points --dims 4" &&
        [ "$(grep -o h0 points.svg | wc -l)" -eq 600 ]
}
check "-o writes a table and a drawing of every pair" files

order() { ends 0 points --sequence halton:2,3 --count 50 --order -o order.svg && [ "$(grep -o h0 order.svg | wc -l)" -eq 98 ]; }
check "--order draws every step" order

figures() {
    for figure in 1 2; do
        ends 0 points --figure $figure -o figure.svg && silent out && says figure.svg ">Figure $figure" &&
            [ "$(wc -c <figure.svg)" -lt 300000 ] && ends 0 points --figure $figure && cmp out figure.svg || return
    done
    command=$(sed -n 's/^command: multipath //p' figure.svg)
    ends 0 $command && cmp out figure.svg
}
check "the paper's figures are drawn, to a file or to stdout, and say how to make them again" figures

discrepancy() {
    ends 0 points --count 1024 --discrepancy -o table.csv && lines_are out 14 && silent err && says table.csv "1024,0.0009" &&
        ends 0 points --dims 3 --count 4 --discrepancy && [ "$(tail -n 1 out | wc -w)" -eq 3 ]
}
check "--discrepancy prints a table, and writes it" discrepancy

# The first 2^k of Sobol's points in one dimension are i/2^k: L2 star discrepancy 2^-k / sqrt 3. Point 1 is at 1/2: half of that.
discrepancies() {
    ends 0 points --dims 1 --count 10 --discrepancy -o one.csv && grep -v '^#' one.csv | awk -F, '
        NR == 1 { if ($0 != "count,l2_star,random_l2_star") exit 1; next }
        { counts = counts " " $1; if ($1 < 10 && ($1 * $2 * sqrt(3) - 1) ^ 2 > 1e-20) exit 1 } END { exit counts != " 1 2 4 8 10" }' &&
        ends 0 points --dims 1 --count 8 --discrepancy -o eight.csv && [ "$(grep -c '^8,' eight.csv)" -eq 1 ] &&
        ends 0 points --dims 1 --skip 1 --count 1 --discrepancy && says out " 2.8868e-01" || return
    ends 0 points --dims 3 --count 4 --discrepancy -o three.csv && tail -n 1 three.csv | grep -Eq '^4,0\.[0-9]{17},0\.[0-9]{17}$' &&
        grep -qx '   points      L2 star    if random' out &&
        grep -qx '        1   8.8715e-01   2.9659e-01' out
}
check "the discrepancies are of 1, 2, 4 ... points and of all, exact in the table and aligned in the text" discrepancies

# usage: refused TEXT ARGS...
refused() {
    text=$1
    shift
    ends 2 points "$@" && silent out && says err "$text"
}
check "no points are refused" refused "--count: expected a count" --count 0
check "no dimensions are refused" refused "--dims: expected a count" --dims 0
check "more dimensions than the sequence has are refused with its reason" refused "--sequence: " --dims 7
check "and another one that has them is named" refused "halton with that many bases has more" --sequence kronecker --dims 7
check "an unknown sequence is refused" refused "unknown sequence 'sobl'" --sequence sobl
check "points beyond the sequence's end are refused" refused "ends after 64 points" --sequence hammersley:64 --count 65
check "skipping beyond the sequence's end is refused" refused "ends after" --skip 2^63
check "an order without a drawing is refused" refused "--order: needs a drawing" --order
check "a drawing in one dimension is refused" refused "from 2 to 8 dimensions" --dims 1 -o a.svg
check "a matrix of very many plots is refused" refused "from 2 to 8 dimensions" --sequence random --dims 9 -o a.svg
check "too many dots are refused" refused "from 1 to 65536" --count 1M -o a.svg
check "a picture is refused, with what there is instead" refused "expected one of .csv, .svg" -o a.png
check "a figure as a table is refused" refused "expected one of .svg" --figure 1 -o a.csv
check "a figure of a chosen sequence is refused" refused "--sequence: has no effect" --figure 1 --sequence sobol
check "a figure that the command does not have is refused" refused "--figure: expected one of" --figure 3
check "discrepancies of too many points are refused" refused "from 1 to 16384" --count 1M --discrepancy
check "a drawing of discrepancies is refused" refused "expected one of .csv" --discrepancy -o a.svg

no_traces() { ! ls | grep '^a\.'; }
check "what is refused leaves no file" no_traces
finish
