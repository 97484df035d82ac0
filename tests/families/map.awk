# Who wins where, as a Markdown table of rooms.csv: for each room and each effort (patches, lines for each) the method with
# the least error times processor time, and in brackets the second and how many times as much it takes.
#   awk -F, -f map.awk rooms.csv

NR == 1 { next }
{
    effort = $3 "," $5
    if ($1 " " $2 "," effort != last) {
        show()
        last = $1 " " $2 "," effort
        count = 0
        room = $1 " " $2
        if (!(room in efforts)) rooms[room_count++] = room
        ++efforts[room]
        crossings[room] = $4
    }
    name[count] = $6
    cost[count++] = $7 * $9
}
END {
    show()
    print "| room | crossings of a line | first effort | second | third |"
    print "| --- | --- | --- | --- | --- |"
    for (k = 0; k < room_count; ++k) {
        room = rooms[k]
        printf "| %s | %.1f | %s | %s | %s |\n", room, crossings[room], cell[room, 1], cell[room, 2], cell[room, 3]
    }
}
function show(    k, first, second) {
    if (count == 0) return
    first = second = -1
    for (k = 0; k < count; ++k)
        if (first < 0 || cost[k] < cost[first]) { second = first; first = k }
        else if (second < 0 || cost[k] < cost[second]) second = k
    cell[room, efforts[room]] = sprintf("%s (%s %.3g)", name[first], name[second], cost[second] / cost[first])
}
