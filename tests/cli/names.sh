# Names of files as each system has them, and lines that end alike on all: upper and lower case, folders, devices, UTF-8.
. "$2/tests/cli/check.sh"
scene=$root/scenes/cube.obj
quick="--patches 100 --size 8x8 --quiet"
few="--lines 1000 $quick"
on_windows() { case $program in *.exe) "$@" ;; esac; }
# Wine takes names for those of the locale.
LC_ALL=C.UTF-8
export LC_ALL

# usage: one_file NAME OTHER      names of one file, which is not there: refused, and nothing is left
one_file() {
    rm -rf new && mkdir new && ends 2 solve "$scene" $few -o "$1" -o "$2" && says err "'$2' is named twice" && [ -z "$(ls -A new)" ]
}
other_case() { one_file new/A.csv new/a.csv && one_file new/a.csv NEW/a.csv; }
two_files() { ends 0 solve "$scene" $few -o A.csv -o a.csv && [ -s A.csv ] && cmp a.csv A.csv; }
case $program:$(uname) in
*.exe:* | *:Darwin) check "names that differ in case are one output where the system ignores case" other_case ;;
*) check "names that differ in case are two outputs where the system tells them apart" two_files ;;
esac

# A state is replaced while it is resumed, outputs are replaced where they stand.
backslashes() {
    mkdir -p sub/deep && set -- "$scene" $quick -o 'sub\deep\a.csv' -o 'sub\b.png' --state 'sub\a.state' &&
        ends 0 solve "$@" --lines 1000 && ends 0 solve "$@" --lines 2000 --resume && ends 0 compare sub/a.state sub/deep/a.csv --tolerance 0 &&
        [ "$(ls -A sub sub/deep | tr '\n' ' ')" = "sub: a.state b.png deep  sub/deep: a.csv " ] &&
        one_file 'new\a.csv' new/a.csv && one_file 'new\a.csv' 'new\..\new\a.csv'
}
on_windows check "folders may be separated by backslashes" backslashes

# It takes everything, with any extension.
devices() {
    ends 2 solve "$scene" $few -o NUL && says err "'NUL' does not end in a known extension" || return
    ends 0 solve "$scene" $few -o NUL.csv -o kept.csv && [ -s kept.csv ] && [ -z "$(find . -iname '*nul*')" ]
}
on_windows check "the device NUL is no file" devices

# usage: scene_with FOLDER TEXTURE-NAME      the cube there, its walls with the picture FOLDER/Maps/wood.ppm
scene_with() {
    mkdir -p "$1/Maps" && cp "$scene" "$1" && printf 'P3 2 1 255 255 128 0 40 80 120\n' >"$1/Maps/wood.ppm" &&
        sed "s|^newmtl.*|&\nmap_Kd $2|" "$root/scenes/cube.mtl" >"$1/cube.mtl"
}
textures() {
    scene_with slashes Maps/wood.ppm && scene_with back 'maps\\Wood.ppm' &&
        for folder in slashes back; do
            (cd $folder && ends 0 solve cube.obj $few -o a.csv && ends 2 solve cube.obj $few -o Maps/wood.ppm &&
                says err "is an input") || return
        done
    cmp slashes/a.csv back/a.csv && ends 0 solve "$scene" $few -o plain.csv && grep -v '^#' plain.csv >plain &&
        grep -v '^#' back/a.csv >pictured && ! cmp -s plain pictured
}
check "textures are found by the paths of any system" textures

beyond_ascii() {
    scene_with "Räume für 5 €" "Maps/wood.ppm" && cd "Räume für 5 €" && mv Maps/wood.ppm Maps/Bäume.ppm && mv cube.obj Würfel.obj &&
        sed 's/wood/Bäume/' cube.mtl >new.mtl && mv new.mtl cube.mtl || return
    set -- "Räume für 5 €/Würfel.obj" $quick --state "Räume für 5 €/Zustand.state" -o "Räume für 5 €/Größe λ.csv"
    cd .. && ends 0 solve "$@" --lines 1000 && ends 0 solve "$@" --lines 2000 --resume && cd "Räume für 5 €" &&
        [ "$(printf '%s\n' *)" = "$(printf '%s\n' "Größe λ.csv" Maps Würfel.obj Zustand.state cube.mtl | sort)" ] &&
        grep -q '^# command: .*Würfel.obj' "Größe λ.csv" || return
    printf 'newmtl old\nmap_Kd B\344ume.ppm\n' >>cube.mtl && ends 0 check Würfel.obj --lines 1000 # Latin-1, of an old file
}
check "names may have any characters" beyond_ascii

line_ends() {
    mkdir text && ends 0 solve "$scene" --patches 100 --lines 1000 --json -o text/a.csv -o text/a.obj -o text/a.html && mv out err text &&
        ends 0 explain "$scene" --of 1000 -o text/a.svg && mv out text/explain.txt && ends 0 help solve && mv out text/help.txt &&
        ends 0 check "$scene" --lines 1000 && mv out text/check.txt && ends 1 check none.obj && mv err text/refused.txt &&
        "$program" solve "$scene" $few -o - >text/a.ppm && ends 0 solve "$scene" $few -o same.ppm && cmp same.ppm text/a.ppm || return
    rm text/a.ppm
    ! grep -l "$(printf '\r')" text/* && [ -s text/err ] && [ -s text/check.txt ]
}
check "lines end alike on all systems" line_ends
finish
