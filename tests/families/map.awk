# Who wins where: a row of a Markdown table for each room of rooms.csv, with the best method, the second, and the best one
# of the paper, and error times processor time of these as multiples of the least.
#   awk -F, -f map.awk rooms.csv

NR == 1 { print "| room | crossings of a line | patches | lines for each | best | second | best of the paper's |"; print "| --- | --- | --- | --- | --- | --- | --- |"; next }
{
    room = $1 " " $2 "|" $4 "|" $3 "|" $5
    if (room != last) { show(); last = room; count = 0 }
    name[count] = $6; cost[count++] = $7 * $9
}
END { show() }
function show(    k, first, second, paper) {
    if (count == 0) return
    first = second = paper = -1
    for (k = 0; k < count; ++k) {
        if (first < 0 || cost[k] < cost[first]) { second = first; first = k }
        else if (second < 0 || cost[k] < cost[second]) second = k
        if (name[k] ~ /^(global|first-shot|extended|local)$/ && (paper < 0 || cost[k] < cost[paper])) paper = k
    }
    split(last, part, "|")
    printf "| %s | %.1f | %d | %d | %s | %s, %.3g | %s, %.3g |\n", part[1], part[2], part[3], part[4], name[first], name[second],
        cost[second] / cost[first], name[paper], cost[paper] / cost[first]
}
