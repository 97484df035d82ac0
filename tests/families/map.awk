# Who wins where, as Markdown tables of rooms.csv: for each room and each effort (patches, lines for each) the method with
# the least error times processor time, and in brackets the second and how many times as much it takes. A case is a room
# with an effort; where a room has more faces than the patches wanted, two efforts are one case. The second table is of
# the methods: in how many cases each takes least, what it takes in all cases as a multiple of the least there (geometric
# mean, and the most), in how many it has the least error with the same lines, and its memory. Below: the cases in which
# reuse does not take least; then what methods take as multiples of another, least, most and geometric mean, by lamps or
# sky; the same for errors alone.
#   awk -F, -f map.awk rooms.csv

NR == 1 { next }
{
    effort = $3 "," $5
    if ($1 " " $2 "," effort != last) {
        show()
        last = $1 " " $2 "," effort
        count = 0
        room = $1 " " $2
        lit_by = $1 == "courtyard" ? "sky" : "lamps"
        if (!(room in efforts)) rooms[room_count++] = room
        ++efforts[room]
        crossings[room] = $4
        patches = $3
        lines_each = $5
    }
    name[count] = $6
    error[count] = $7
    memory[count] = $10
    cost[count++] = $7 * $9
}
END {
    show()
    print "| room | crossings of a line | 500 patches, 64 lines each | 4,000, 64 | 500, 512 |"
    print "| --- | --- | --- | --- | --- |"
    for (k = 0; k < room_count; ++k) {
        room = rooms[k]
        printf "| %s | %.1f", room, crossings[room]
        for (effort = 1; effort <= 3; ++effort) printf " | %s", (room, effort) in cell ? cell[room, effort] : "–"
        print " |"
    }
    print "\n| method | takes least | over the least: mean | at most | least error | memory [MB] |"
    print "| --- | --- | --- | --- | --- | --- |"
    for (k = 0; k < method_count; ++k) {
        m = methods[k]
        printf "| %s | %d of %d | %s | %s, %s | %d of %d | %d to %d |\n", m, wins[m], cases, three(exp(logarithms[m] / cases)),
            three(most[m]), where[m], exact[m], cases, least_memory[m], most_memory[m]
    }
    printf "\n%s", losses
    for (k = 0; k < pair_count; ++k) {
        pair = pairs[k]
        printf "%s: %.2f to %.2f times as much, mean %.2f\n", pair, low[pair], high[pair], exp(sum[pair] / pair_cases[pair])
    }
}
# Three digits.
function three(x) { return sprintf(x < 100 ? "%.3g" : "%.0f", x) }
function compare(pair, times) {
    if (!(pair in low)) { pairs[pair_count++] = pair; low[pair] = high[pair] = times }
    if (times < low[pair]) low[pair] = times
    if (times > high[pair]) high[pair] = times
    sum[pair] += log(times)
    ++pair_cases[pair]
}
function show(    k, m, times, first, second, exactest) {
    if (count == 0) return
    if (last in shown) { cell[room, efforts[room]] = "the same"; return }
    shown[last] = 1
    first = second = exactest = -1
    for (k = 0; k < count; ++k) {
        of[name[k]] = k
        if (name[k] ~ /-(pilot|raw)$/) continue # a method with another option
        if (first < 0 || cost[k] < cost[first]) { second = first; first = k }
        else if (second < 0 || cost[k] < cost[second]) second = k
        if (exactest < 0 || error[k] < error[exactest]) exactest = k
    }
    ++cases
    ++wins[name[first]]
    ++exact[name[exactest]]
    cell[room, efforts[room]] = sprintf("%s (%s %s)", name[first], name[second], three(cost[second] / cost[first]))
    if (name[first] != "reuse")
        losses = losses sprintf("reuse takes %.2f times as much as %s: %s, %d patches, %d lines for each\n", cost[of["reuse"]] / cost[first],
            name[first], room, patches, lines_each)
    for (k = 0; k < count; ++k) {
        m = name[k]
        times = cost[k] / cost[first]
        if (m !~ /-(pilot|raw)$/) {
            if (!(m in most)) { methods[method_count++] = m; least_memory[m] = memory[k] }
            logarithms[m] += log(times)
            if (times > most[m]) { most[m] = times; where[m] = room }
            if (memory[k] < least_memory[m]) least_memory[m] = memory[k]
            if (memory[k] > most_memory[m]) most_memory[m] = memory[k]
        }
        if (m != "extended") compare(lit_by ", " m " over extended", cost[k] / cost[of["extended"]])
    }
    compare(lit_by ", gathering over local", cost[of["gathering"]] / cost[of["local"]])
    compare(lit_by ", reuse-raw over reuse", cost[of["reuse-raw"]] / cost[of["reuse"]])
    compare("error of reuse-raw over reuse", error[of["reuse-raw"]] / error[of["reuse"]])
    compare(lit_by ", error of extended-pilot over extended", error[of["extended-pilot"]] / error[of["extended"]])
}
