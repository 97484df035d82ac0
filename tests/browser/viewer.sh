# The page of a solved room in a real browser, without a network and without a graphics card. The program's own pictures
# say what must be seen: the same camera, the same patches, the same colours.
# usage: viewer.sh PROGRAM ROOT [SCREENSHOT]     in an empty folder; CHROMIUM names the browser (chromium)
. "$2/tests/cli/check.sh"
screenshot=${3:-viewer.png}
chromium=${CHROMIUM:-chromium}

# usage: browse OPTIONS... URL
browse() {
    timeout 300 "$chromium" --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader \
        --hide-scrollbars --allow-file-access-from-files --host-resolver-rules="MAP * ~NOTFOUND" \
        --enable-logging=stderr "$@" 2>browser.log
}

# A page with a frame of 800 x 600 pixels, which the room fills when the controls are hidden, and functions that look at it.
# usage: write_look STATEMENT
write_look() {
    cat >look.html <<HTML
<!DOCTYPE html><meta charset="utf-8"><pre id="result">the page did not load</pre>
<iframe id="frame" style="width:800px;height:600px;border:0"></iframe>
<img id="drawn" alt="" hidden>
<script src="$root/tests/browser/viewer_looks.js"></script>
<script>$1;</script>
HTML
}

# The functions of viewer_looks.js that look at each page of a run of the browser, which takes seconds to start.
rooms="{ '5cubes': [patches_found, picture_compared, first_view, click_on_patch, lines_traced, quantities_shown, \
    keys_pressed, room_kept, view_saved, names_of_controls], sphere: [patches_found, picture_compared], sided: [patches_found, picture_compared], \
    textured: [patches_found, picture_compared], far: [patches_found, picture_compared, view_saved] }"
chairs="{ '4chairs': [first_view] }"

# What one of these functions finds becomes the lines of `seen`. The browser's virtual time passes while other threads of
# it work: on a busy machine more of it is needed.
# usage: look PAGE FUNCTION
look() {
    dom=rooms.dom pages=$rooms
    [ "$1" = 4chairs ] && dom=4chairs.dom pages=$chairs
    for budget in 100000 1000000; do
        if [ ! -f "$dom" ]; then
            write_look "look_at($pages)"
            browse --virtual-time-budget=$budget --window-size=900,700 --dump-dom "file://$PWD/look.html" >"$dom"
            cat browser.log >>console.log
        fi
        sed -n 's/.*<pre id="result">//; /^[a-z_]* .*/p' "$dom" | sed -n "/^look $1 $2\$/,/^end /p" >seen
        grep -q '^end ' seen && return
        mv "$dom" failed.dom
    done
    head -c 1000 failed.dom
    tail -n 5 browser.log
    return 1
}

# usage: value NAME       the rest of a finding's line
value() { sed -n "s/^$1 //p" seen; }

# usage: holds AWK_CONDITION, which may name findings with one number each
holds() {
    awk -v condition="$1" '{ v[$1] = $2 } END { exit !('"$(printf '%s' "$1" | sed 's/[a-z_][a-z_]*/v["&"]/g')"') }' seen && return
    echo "not so: $1"
    cat seen
    return 1
}

# One sample in the middle of every pixel, and patches in flat colours: what a click must find.
# usage: solved NAME FILE OPTIONS...
solved() {
    name=$1 file=$2
    shift 2
    "$program" solve "$file" --lines 2^14 "$@" --quiet -o "$name.html" -o "$name.png" &&
        "$program" solve "$file" --lines 2^14 "$@" --samples 1 --shading flat --quiet -o "$name.pfm"
}
# Triangles with much noise, so that neighbours differ; a wall seen from its dark back beside the room behind it. Both
# are cut adaptively.
check "rooms are solved" solved 5cubes "$root/scenes/5cubes.obj"
check "so are triangles" solved sphere "$root/scenes/sphere.obj" --method global --eye 0.2,0.3,0.1 --target 1,-0.4,0.3 --adaptive 1500
check "and both sides of surfaces" solved sided "$root/scenes/cornell.obj" --two-sided --eye=-0.5,0.4,1.2 --adaptive 4000

# White surfaces with a picture that is repeated, from a file that browsers do not read; red ones with one that is not.
textured() {
    printf 'P3 3 2 255\n255 255 255 90 120 90\n100 100 160 255 200 255\n 180 180 90 140 200 240\n' >fields.ppm
    "$program" solve "$root/scenes/cornell.obj" --lines 2^14 --quiet --show normals --size 64x48 -o room.png || return
    { printf 'vt 0 0\nvt 2 0.5\nvt 1.5 2.5\nvt -0.5 2\n'; sed 's/^\(f [0-9-]*\) \([0-9-]*\) \([0-9-]*\) \([0-9-]*\)$/\1\/1 \2\/2 \3\/3 \4\/4/; s/^mtllib .*/mtllib textured.mtl/' "$root/scenes/cornell.obj"; } >textured.obj
    sed 's/^newmtl white.*/&\nmap_Kd fields.ppm/; s/^newmtl red.*/&\nmap_Kd -clamp on room.png/' "$root/scenes/cornell.mtl" >textured.mtl
    solved textured textured.obj
}
check "and those with textures" textured

far_away() {
    awk '$1 == "v" { printf "v %.9f %.9f %.9f\n", $2 + 500000, $3 + 120, $4 + 4649776; next } { print }' "$root/scenes/cornell.obj" >far.obj &&
        cp "$root/scenes/cornell.mtl" . && solved far far.obj --eye 500000.31,120.29,4649777.1 --target 500000.26,120.24,4649776
}
check "and one whose coordinates are those of a map" far_away

# The page's findings `at X Y R G B`, radiosities of patches found at pixels, against the pixels of a PFM of 800 x 600.
# Radiosities of two patches are hardly ever the same, so the patch is the right one. The page holds coordinates with 24
# bits: where a pixel lies on the border of two patches, the program may see one and the page the other, which it sees in
# a pixel beside. Of a thousand pixels a few do.
same_patches() {
    look "$1" patches_found || return
    tail -c $((800 * 600 * 12)) "$1.pfm" | od -An -v -t f4 -w12 | awk -v name="$1" '
        FNR == NR {
            if ($1 != "at") next
            at = (599 - $3) * 800 + $2 + 1
            for (row = -800; row <= 800; row += 800) for (k = -1; k <= 1; ++k) near[at + row + k] = near[at + row + k] " " at
            light[at] = $4 " " $5 " " $6
            next
        }
        FNR in near {
            n = split(near[FNR], places, " ")
            for (i = 1; i <= n; ++i) {
                split(light[places[i]], b, " ")
                same = 1
                for (k = 1; k <= 3; ++k) { d = b[k] - $k; if (d < 0) d = -d; if (d > 1e-6 * (1 + $k)) same = 0 }
                if (same) beside[places[i]] = 1
                if (same && places[i] == FNR) there[places[i]] = 1
            }
        }
        END {
            for (at in light) { ++looked; border += !(at in there); wrong += !(at in beside) }
            print name ": " looked " patches, " border + 0 " on a border, " wrong + 0 " wrong"
            exit !(looked > 400 && wrong == 0 && border <= looked / 200)
        }' seen -
}
check "a click finds the patch that the program sees there" same_patches 5cubes
check "on triangles too" same_patches sphere
check "and on both sides of surfaces" same_patches sided
check "and with textures" same_patches textured
check "and far from the origin" same_patches far

# Edges are smoothed in another way, and there is some noise below a step of the screen.
same_picture() { look "$1" picture_compared && holds 'mean_difference < 0.6 && far_off < 0.01'; }
check "the page shows the picture that the program draws" same_picture 5cubes
check "of triangles too" same_picture sphere
check "and of both sides of surfaces" same_picture sided
check "and of textures" same_picture textured
check "and of a room far from the origin" same_picture far

visible() { look 5cubes first_view && holds 'varied > 0.5 && white > 0.001 && black < 0.05 && red_left > 10 && blue_right > 10'; }
check "the room is drawn: not black, the lamp white, walls that colour what is near" visible

clicked() { look 5cubes click_on_patch && holds 'selected == expected && shown == expected && changed > 0 && after_drag == expected'; }
check "a click shows the patch in the panel and marks it; a drag does not" clicked

trace() {
    look 5cubes lines_traced && holds 'unlike == 0 && skipped > 0 && misnumbered == 0 && lines + skipped == 200 && line == 5 && rows > 0 && darker < 0 && moved > 0' &&
        holds 'power_first > 0 && power_later > power_first && power_again == power_first && notes == 2' &&
        holds 'trace_legend == 0 && later_legend == 1' # the trace is shown in light
}
check "the lines of the method that meet something can be stepped through, and power arrives" trace

shown() { look 5cubes quantities_shown && holds 'direct < 0 - 5 && unlike > 20 && legend == 1 && numbers > 2 && gone == 0 && brighter > 10 && borders > 0'; }
check "other quantities, the exposure and the borders of patches change the picture" shown

# How many frames the browser shows is its own affair: what is asked for is the step that a tap makes.
moved() { look 5cubes keys_pressed && holds 'walked > 0.0005 && orbited > 0.01 && kept < 0.000001 && nearer < 1 && home == 0 && outside == 1 && all > 0.1 && all < 0.9 && help == 1 && folded == 1'; }
check "keys, wheel and drags move the camera" moved

# A quarter of the height is at least a fiftieth of the picture; a box at the middle of the picture a hundredth.
kept() {
    look 5cubes room_kept && holds 'far > 0.02 && far < 0.2 && walked > 0.3 && within == 1' &&
        awk '/^(shifted|looked|orbited) / { ++n; if ($2 < 0.01) exit bad = 1 } END { exit bad || n != 12 }' seen || { cat seen; return 1; }
}
check "nothing that pointer and keys do loses sight of the room" kept

# The program takes the view of the page, from its file and as options, for the same picture.
view_saved() {
    look "$1" view_saved && holds 'width == 1 && bytes > 20000' && value json >seen.json || return
    "$program" solve "$2" --patch-size 1 --lines 2^10 --camera seen.json -q -o by-file.ppm &&
        "$program" solve "$2" --patch-size 1 --lines 2^10 $(value options) -q -o by-options.ppm || return
    for way in file options; do
        tail -c 1440000 by-$way.ppm >by-$way.pixels
    done
    cmp by-file.pixels by-options.pixels &&
        [ "$(value at | awk '{ for (i = 1; i <= 6; ++i) printf "%.6f ", $i }')" = \
            "$(tr -d '{}[]":a-z' <seen.json | tr ',' ' ' | awk '{ for (i = 1; i <= 6; ++i) printf "%.6f ", $i }')" ]
}
check "a view is saved as a file and as options that the program takes, and as a picture" view_saved 5cubes "$root/scenes/5cubes.obj"
check "also far from the origin" view_saved far far.obj

accessible() { look 5cubes names_of_controls && holds 'controls > 12 && nameless == 0 && hidden_focus == 0'; }
check "every control has a name and can be reached by keyboard" accessible

alone() { [ "$(value resources)" = 0 ] && ! grep -Eq '(src|href)="(https?:)?//' ./*.html; }
check "the page loads nothing else" alone

narrow() {
    write_look "look_at({ '5cubes': [names_of_controls] })"
    sed 's/width:800px/width:380px/' look.html >narrow.html && browse --virtual-time-budget=20000 --dump-dom "file://$PWD/narrow.html" >dom.html &&
        grep -qx 'wide 0' dom.html && grep -qx 'hidden_focus 0' dom.html || { grep -a wide dom.html; return 1; }
}
check "on a telephone it is not wider than the screen" narrow

blind() {
    browse --disable-3d-apis --virtual-time-budget=5000 --dump-dom "file://$PWD/5cubes.html" >dom.html
    grep -q 'This browser cannot draw the room: it has no WebGL 2' dom.html
}
check "without WebGL the page says so" blind

no_errors() { ! grep -E 'CONSOLE.*(rror|Refused|WebGL)' console.log; }
check "the console shows no error" no_errors

# In real time: how long until the first picture is drawn and read back. A machine without a graphics card, and with other
# work, is slow: only what is beyond all patience fails.
quick() {
    solved 4chairs 4chairs && look 4chairs first_view || return
    write_look "time_opening('4chairs')"
    mv look.html timed.html && browse --screenshot=timed.png "file://$PWD/timed.html"
    sed -n 's/.*CONSOLE.*"opened in \([0-9]*\) ms.*/\1/p' browser.log >opened
    [ "$(cat opened)" -lt 20000 ]
}
check "the room can be looked at soon after its page is opened" quick
small() { [ "$(wc -c <5cubes.html)" -lt 1500000 ] && [ "$(wc -c <4chairs.html)" -lt 1500000 ]; }
check "the page of a bundled room takes less than 1.5 MB" small
echo "4chairs: first picture after $(cat opened) ms"

# usage: pictured FILE OPTIONS...
pictured() {
    file=$1
    shift
    browse --window-size=1200,800 --virtual-time-budget=5000 "$@" --screenshot="$file" "file://$PWD/4chairs.html" && [ "$(wc -c <"$file")" -gt 50000 ]
}
check "a screenshot is kept" pictured "$screenshot" --blink-settings=preferredColorScheme=1
check "and one in dark colours" pictured "${screenshot%.png}-dark.png" --blink-settings=preferredColorScheme=0
finish
