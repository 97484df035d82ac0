# Who wins where, as a Markdown table of rooms.csv: for each room and each effort (patches, lines for each) the method with
# the least error times processor time, and in brackets the second and how many times as much it takes. A case is a room
# with an effort; where a room has more faces than the patches wanted, two efforts are one case. Below the table: in how
# many cases each method wins, and the least and the most that methods take as multiples of another, by lamps or sky.
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
    }
    name[count] = $6
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
    for (method in wins) printf "%s wins %d of %d cases\n", method, wins[method], cases
    for (pair in least) printf "%s: %.2f to %.2f times as much\n", pair, least[pair], most[pair]
}
function compare(method, other,    pair, times) {
    pair = lit_by ", " method " over " other
    times = of[method] / of[other]
    if (!(pair in least) || times < least[pair]) least[pair] = times
    if (!(pair in most) || times > most[pair]) most[pair] = times
}
function show(    k, first, second) {
    if (count == 0) return
    if (last in shown) { cell[room, efforts[room]] = "the same"; return }
    shown[last] = 1
    first = second = -1
    for (k = 0; k < count; ++k) {
        of[name[k]] = cost[k]
        if (name[k] ~ /-(pilot|raw)$/) continue # a method with another option
        if (first < 0 || cost[k] < cost[first]) { second = first; first = k }
        else if (second < 0 || cost[k] < cost[second]) second = k
    }
    ++cases
    ++wins[name[first]]
    cell[room, efforts[room]] = sprintf("%s (%s %.3g)", name[first], name[second], cost[second] / cost[first])
    for (k = 0; k < count; ++k) if (name[k] != "extended") compare(name[k], "extended")
    compare("gathering", "local")
    if ("reuse-raw" in of) compare("reuse-raw", "reuse")
}
