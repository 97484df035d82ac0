# Writes a room of a family as OBJ, and its materials as MTL beside it:
#   awk -v family=furniture -v size=100 -v out=room.obj -f room.awk
# Families and what `size` counts: furniture (boxes on the floor), building (rooms joined by doors, every second one with
# a lamp), pillars (of a hall; 16, 64, 256, ...), courtyard (boxes between walls under an open sky), lamps (of a ceiling; together as large
# as one). Units are metres. `up=1` turns the lamps of `furniture` to the ceiling, `white=0.9` sets the reflectance,
# `seed=2` makes other boxes. The same rooms with every awk.

# Next number in (0, 1): Park and Miller's generator with the multiplier 48271, Communications of the ACM 36 (1993), p.
# 108. All products are below 2^53, thus exact.
function next_number() {
    state = state * 48271 % 2147483647
    return state / 2147483647
}
# The square root by Newton's method; sqrt() is missing in some builds of busybox.
function root(x,    r, k) {
    r = x
    for (k = 0; k < 50; ++k) r = (r + x / r) / 2
    return r
}
function upper_root(count,    r) {
    while (r * r < count) ++r
    return r
}
function vertex(x, y, z) { print "v", x, y, z > out; return ++vertices }
# A face whose front is where a, b, c, d run anticlockwise.
function face(material, a, b, c, d) {
    if (material != current) print "usemtl", material > out
    current = material
    print "f", a, b, c, d > out
}
# The sides of a box. Fronts outside, or inside with inner = 1. Bottom and top may have materials of their own.
function box(material, x, y, z, wide, high, deep, inner, without_top, bottom, top,    p, k) {
    for (k = 0; k < 8; ++k)
        p[k] = vertex(x + (k % 2) * wide, y + (int(k / 2) % 2) * high, z + int(k / 4) * deep)
    side(bottom ? bottom : material, inner, p[0], p[1], p[5], p[4])
    if (!without_top) side(top ? top : material, inner, p[2], p[6], p[7], p[3])
    side(material, inner, p[0], p[2], p[3], p[1])
    side(material, inner, p[4], p[5], p[7], p[6])
    side(material, inner, p[0], p[4], p[6], p[2])
    side(material, inner, p[1], p[3], p[7], p[5])
}
function side(material, inner, a, b, c, d) {
    if (inner) face(material, d, c, b, a)
    else face(material, a, b, c, d)
}
# A thin box under the ceiling that emits below, or above with up = 1.
function lamp(x, y, z, edge) { box("wall", x, y, z, edge, 0.02, edge, 0, 0, up ? "" : "light", up ? "light" : "") }
function lamps(count, x, z, wide, deep, y, edge,    k, across, step_x, step_z) {
    across = upper_root(count)
    step_x = wide / across; step_z = deep / across
    for (k = 0; k < count; ++k)
        lamp(x + (k % across + 0.5) * step_x - edge / 2, y, z + (int(k / across) + 0.5) * step_z - edge / 2, edge)
}
# Boxes on the floor, each somewhere in a cell of its own.
function boxes(count, x, z, wide, deep, highest,    k, across, cell_x, cell_z, a, c) {
    if (count == 0) return
    across = upper_root(count)
    cell_x = wide / across; cell_z = deep / across
    for (k = 0; k < count; ++k) {
        a = cell_x * (0.2 + 0.4 * next_number()); c = cell_z * (0.2 + 0.4 * next_number())
        box("thing", x + (k % across) * cell_x + (cell_x - a) * (0.05 + 0.9 * next_number()), 0.001,
            z + int(k / across) * cell_z + (cell_z - c) * (0.05 + 0.9 * next_number()), a, highest * (0.2 + 0.8 * next_number()), c)
    }
}
# A wall between two rooms of the building, from (x, z) along one axis, with a door of 1 m by 2.1 m in its middle. Where
# walls meet there are pillars as thick as they are.
function wall_with_door(x, z, along_x, long, high) {
    part("wall", x, z, along_x, thick / 2, (long - 1) / 2, 0, high)
    part("wall", x, z, along_x, (long - 1) / 2, (long + 1) / 2, 2.1, high)
    part("wall", x, z, along_x, (long + 1) / 2, long - thick / 2, 0, high)
}
function part(material, x, z, along_x, from, to, low, high) {
    if (along_x) box(material, x + from, low, z - thick / 2, to - from, high - low, thick)
    else box(material, x - thick / 2, low, z + from, thick, high - low, to - from)
}
BEGIN {
    state = seed ? seed : 1
    for (k = 0; k < 16; ++k) next_number() # small seeds begin with small numbers
    thick = 0.1
    if (white == "") white = 0.6
    materials = out
    sub(/\.obj$/, ".mtl", materials)
    base = materials
    sub(/.*\//, "", base)
    printf "newmtl wall\nKd %g %g %g\nnewmtl thing\nKd %g %g %g\nnewmtl light\nKd 0 0 0\nKe 20 20 20\n", white, white, white,
        0.9 * white, 0.7 * white, 0.5 * white > materials
    print "mtllib " base > out
    if (family == "furniture") {
        box("wall", 0, 0, 0, 6, 3, 6, 1)
        boxes(size, 0, 0, 6, 6, 1.2)
        lamps(1, 0, 0, 6, 6, up ? 2.5 : 2.95, 1)
    } else if (family == "building") {
        across = upper_root(size)
        rows = int((size + across - 1) / across)
        box("wall", 0, 0, 0, 4 * across, 3, 4 * rows, 1)
        for (i = 0; i < across; ++i)
            for (j = 0; j < rows; ++j) {
                if (i > 0) wall_with_door(4 * i, 4 * j, 0, 4, 3)
                if (j > 0) wall_with_door(4 * i, 4 * j, 1, 4, 3)
                if (i > 0 && j > 0) box("wall", 4 * i - thick / 2, 0, 4 * j - thick / 2, thick, 3, thick)
                if ((i + j) % 2 == 0) lamps(1, 4 * i, 4 * j, 4, 4, 2.95, 0.6)
            }
    } else if (family == "pillars") {
        box("wall", 0, 0, 0, 20, 5, 20, 1)
        across = upper_root(size)
        for (k = 0; k < size; ++k)
            box("thing", (k % across + 0.35) * 20 / across, 0, (int(k / across) + 0.35) * 20 / across, 6 / across, 5, 6 / across)
        edge = 6 / 32 # fits between 1,024 pillars
        for (k = 0; k < 9; ++k) # above the aisles
            lamp(5 * (k % 3 + 1) - edge / 2, 4.9, 5 * (int(k / 3) + 1) - edge / 2, edge)
    } else if (family == "courtyard") {
        box("wall", 0, 0, 0, 20, 10, 20, 1, 1)
        boxes(size, 0, 0, 20, 20, 3)
    } else if (family == "lamps") {
        box("wall", 0, 0, 0, 10, 3, 10, 1)
        boxes(20, 0, 0, 10, 10, 1.5)
        lamps(size, 0, 0, 10, 10, 2.95, 1 / root(size))
    } else {
        print "no family is called " family | "cat 1>&2"
        exit 2
    }
}
