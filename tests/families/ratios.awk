# Of ratios.md: the rows with random lines as the table of docs/family.md, one for a room; and for each sequence the most
# that either rule loses, and how often the law is given up.
#   awk -F ' [|] ' -f ratios.awk ratios.md
NR > 2 {
    sub(/^[|] /, "", $1)
    sub(/ [|]$/, "", $6)
    split($1, name, ", ")
    if (name[2] == "random") {
        line = $2 " | " $4 " | " $5 " | " $6
        if (name[3] == "first-shot") first = line
        else print "| " name[1] " | " first " | " line " |"
    }
    kind = name[2] ", " name[3]
    split($4, formula, "[: ]+")
    split($5, pilot, "[: ]+")
    if (formula[2] >= most[kind, "(3)"] + 0) { most[kind, "(3)"] = formula[2]; where[kind, "(3)"] = name[1] }
    if (pilot[2] >= most[kind, "pilot"] + 0) { most[kind, "pilot"] = pilot[2]; where[kind, "pilot"] = name[1] }
    if (formula[2] <= 1.03) ++near[kind, "(3)"]
    if (pilot[2] <= 1.03) ++near[kind, "pilot"]
    ++rooms[kind]
    given_up[kind] += $2 ~ /measured/
}
END {
    split("random, first-shot|random, extended|sobol, first-shot|sobol, extended", kinds, "|")
    split("(3) pilot", rules, " ")
    for (r = 1; r <= 2; ++r)
        for (k = 1; k <= 4; ++k) {
            kind = kinds[k]; rule = rules[r]
            printf "%s, %s: at most %.0f %%, %s; at most 3 %% in %d of %d\n", kind, rule, 100 * (most[kind, rule] - 1),
                where[kind, rule], near[kind, rule], rooms[kind]
        }
    for (k = 1; k <= 4; ++k) printf "%s: the law is given up in %d of %d\n", kinds[k], given_up[kinds[k]], rooms[kinds[k]]
}
