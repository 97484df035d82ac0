# Checks that every include in the source folder points down or stays in its room (main.cpp may include all rooms).
# Prints nothing when all do, else one line for each that does not.
# usage: include_order.sh SRC
src=${1%/}
[ -d "$src" ] || { echo "include_order.sh: no folder '$src'"; exit 2; }

complaints=$(find "$src" -type f \( -name '*.h' -o -name '*.h??' -o -name '*.cpp' -o -name '*.cc' -o -name '*.inl' \) \
    -exec awk -v src="$src" '
    BEGIN {
        below["base"] = ""
        below["parallel"] = " base "
        below["geometry"] = " parallel base "
        below["sampling"] = below["scene"] = " geometry parallel base "
        below["image"] = below["export"] = below["transport"] = " geometry scene sampling parallel base "
        below["radiosity"] = below["transport"] "transport "
        below["check"] = below["radiosity"] "radiosity "
        below["selftest"] = below["explain"] = below["radiosity"] "export radiosity "
        below["viewer"] = below["image"] "image export explain "
        below["refinement"] = below["radiosity"] "image radiosity "
        below["study"] = below["radiosity"] "image export radiosity check "
        below["cli"] = " geometry scene parallel base "
        below["commands"] = below["study"] "study refinement selftest viewer explain cli "
        below["main.cpp"] = below["commands"] "commands "
        for (i = 1; i < ARGC; ++i)
            if (!(room_of(ARGV[i]) in below))
                print ARGV[i] ":1: unknown room \047" room_of(ARGV[i]) "\047"
    }
    function room_of(path) {
        path = substr(path, length(src) + 2)
        sub("/.*", "", path)
        return path
    }
    /^[ \t]*#[ \t]*include[ \t]*["<]/ {
        room = room_of(FILENAME)
        named = $0
        sub(/^[^"<]*/, "", named)
        quoted = named ~ /^"/
        named = substr(named, 2)
        sub(/[">].*/, "", named)
        target = named
        sub("/.*", "", target)
        if (!quoted && !(target in below) || !(room in below))
            next
        stays = target == room && room != "main.cpp"
        if (!quoted || named !~ "/" || named ~ /\.\./ || !stays && index(below[room], " " target " ") == 0)
            print FILENAME ":" FNR ": room \047" room "\047 may not include \047" named "\047"
    }' {} + | sort)

[ "$complaints" ] || exit 0
echo "$complaints"
exit 1
