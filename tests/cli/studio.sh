# The scene STUDIO: the files are those that its script makes, and the program finds nothing wrong with them.
. "$2/tests/cli/check.sh"

# The pixels of a PNG file of one block of data: how well they are compressed depends on the version of zlib.
pixels() { python3 -c 'import sys, zlib; b = open(sys.argv[1], "rb").read(); at = b.index(b"IDAT"); size = int.from_bytes(b[at - 4:at], "big"); sys.stdout.buffer.write(b[:at - 4] + zlib.decompress(b[at + 4:at + 4 + size]))' "$1"; }
made_again() {
    mkdir made && python3 "$root/scenes/studio/studio.py" made && cmp made/studio.obj "$root/scenes/studio.obj" &&
        cmp made/studio.mtl "$root/scenes/studio.mtl" || return
    for texture in made/studio/*.png; do
        pixels "$texture" >new && pixels "$root/scenes/studio/${texture##*/}" >old && cmp new old || return
    done
    [ "$(ls made/studio/*.png | wc -l)" -eq "$(ls "$root"/scenes/studio/*.png | wc -l)" ]
}
command -v python3 >/dev/null && check "the script makes every file of the scene again" made_again

sound() {
    ends 0 check "$root/scenes/studio.obj" --json && ! says out '"makes_wrong_result": true' && ends 0 check "$root/scenes/studio.obj" &&
        says out "findings:" && ! grep -E '^ *(WRONG|warning)|texture|coincident|cop(y|ies) of a face' out
}
check "check finds no fault in it: closed solids, no coincident faces, every texture read" sound

by_day() {
    ends 0 solve "$root/scenes/studio.obj" --sky 60,75,95 --sun 83,46,130,114,92 --patch-size 1 --lines 2^20 -o day.png --size 80x60 &&
        ! grep '^warning' out err
}
check "it is solved by day without a warning" by_day
finish
