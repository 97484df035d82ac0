# Draws a family from rooms.csv as SVG: error times processor time of every method over the size, as a multiple of the
# least one in the same room.
#   awk -F, -v family=furniture -v patches=4000 -v lines=64 -f figure.awk rooms.csv >furniture.svg
# `patches`: of the rooms whose number of patches is nearest; `lines`: for each patch.

function log10(x) { return log(x) / log(10) }
function across(k) { return 70 + 430 * (sizes > 1 ? k / (sizes - 1) : 0.5) }
function down(times) { return 330 - 290 * log10(times) / top }
function away(n) { return n > patches ? n - patches : patches - n }
NR > 1 && $1 == family && $5 == lines {
    if (!($2 in nearest)) { size[sizes++] = $2; nearest[$2] = $3 }
    if (away($3) < away(nearest[$2])) nearest[$2] = $3
    cost[$6, $2, $3] = $7 * $9
    if (!($6 in number)) { number[$6] = methods; method[methods++] = $6 }
}
END {
    split("#0072b2 #d55e00 #009e73 #cc79a7 #e69f00 #56b4e9 #000000 #888888 #882255 #44aa99", colour, " ")
    top = 1
    for (k = 0; k < sizes; ++k) {
        s = size[k]; n = nearest[s]
        for (m = 0; m < methods; ++m) if (!(k in best) || cost[method[m], s, n] < best[k]) best[k] = cost[method[m], s, n]
        for (m = 0; m < methods; ++m) {
            times[m, k] = cost[method[m], s, n] / best[k]
            if (log10(times[m, k]) > top) top = log10(times[m, k])
        }
    }
    top = int(top) + 1
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"680\" height=\"390\" font-family=\"sans-serif\" font-size=\"12\">"
    print "<rect width=\"680\" height=\"390\" fill=\"#fff\"/>"
    printf "<text x=\"285\" y=\"22\" text-anchor=\"middle\" font-size=\"15\">%s</text>\n", family
    for (d = 0; d <= top; ++d)
        printf "<path d=\"M70 %.1fH500\" stroke=\"#ddd\"/><text x=\"62\" y=\"%.1f\" text-anchor=\"end\">%s</text>\n", down(10 ^ d), down(10 ^ d) + 4, 10 ^ d
    for (k = 0; k < sizes; ++k)
        printf "<text x=\"%.1f\" y=\"350\" text-anchor=\"middle\">%s</text>\n", across(k), size[k]
    print "<text x=\"285\" y=\"374\" text-anchor=\"middle\">size</text>"
    print "<text transform=\"translate(18 185) rotate(-90)\" text-anchor=\"middle\">error x seconds over the least</text>"
    for (m = 0; m < methods; ++m) {
        path = ""
        for (k = 0; k < sizes; ++k) {
            path = path (k ? "L" : "M") sprintf("%.1f %.1f", across(k), down(times[m, k]))
            printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"%s\"/>\n", across(k), down(times[m, k]), colour[m + 1]
        }
        printf "<path d=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.4\"/>\n", path, colour[m + 1]
        printf "<circle cx=\"522\" cy=\"%d\" r=\"3.5\" fill=\"%s\"/><text x=\"532\" y=\"%d\">%s</text>\n", 50 + 20 * m, colour[m + 1], 54 + 20 * m, method[m]
    }
    print "</svg>"
}
