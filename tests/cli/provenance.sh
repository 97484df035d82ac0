# The command in a file's header: a shell that runs it again gets the same bytes.
. "$2/tests/cli/check.sh"
cp -r "$root/scenes" . && mkdir again
scene=scenes/5cubes.obj
small="--patch-size 1 --size 40x30"

# The recorded command of a table or drawing.
record_of() { sed -n 's/^# command: //p; s/^command: //p' "$1" | sed "s/&lt;/</g; s/&gt;/>/g; s/&quot;/\"/g; s/&amp;/\&/g"; }

# What a recorded command runs: the program with $outputs as well, in front of operands.
multipath() {
    subcommand=$1
    shift
    "$program" "$subcommand" $outputs "$@" >/dev/null 2>&1
}

# Runs the command that FILE.csv or FILE.svg holds again, and compares all files.
# usage: same FILE EXTENSION...     the command is read from the first one
same() {
    file=$1 command=$(record_of "$1.$2") outputs=
    shift
    case $command in multipath\ *) ;; *) echo "no command in $file.$1"; return 1 ;; esac
    for extension; do outputs="$outputs -o again/$file.$extension"; done
    eval "$command" || { echo "fails: $command"; return 1; }
    for extension; do cmp "$file.$extension" "again/$file.$extension" || { echo "differs: $command"; return 1; }; done
}

solved() {
    ends 0 solve $scene $small --lines 5000 --quiet -o room.csv -o room.png -o room.ppm -o room.pfm -o room.ply -o room.glb \
        -o room.obj -o room.html && same room csv png ppm pfm ply glb obj html
}
check "what solve has written comes out again" solved

every_record() {
    command=$(record_of room.csv)
    for file in room.png room.ppm room.ply room.glb room.obj room.html; do
        grep -aqF "$command" $file || { echo "no command in $file"; return 1; }
    done
}
check "every file that can hold text has the command" every_record

points() {
    ends 0 points --dims 3 --count 64 --sequence sobol-owen -o points.csv -o points.svg && same points csv svg &&
        ends 0 points --count 16 --discrepancy -o even.csv && same even csv &&
        ends 0 points --figure 2 --count 100 -o figure.svg && same figure svg
}
check "points come out again, as tables and drawings" points

explain() {
    for arguments in "" "--stage extended:2 --method extended --threads 2" "--method local --up 0,0,1"; do
        ends 0 explain $scene --of 4096 $arguments -o lines.svg && same lines svg || return
    done
}
check "drawings of single lines come out again" explain

study() {
    ends 0 study $scene --patch-size 1 --from 2^8 --to 2^10 --replicates 2 --methods extended,reuse --quiet -o study.svg &&
        same study svg &&
        ends 0 study $scene --patch-size 1 --from 2^8 --to 2^10 --replicates 2 --methods global --reference room.csv --quiet \
            -o by-room.svg && same by-room svg
}
check "a study comes out again, computed anew" study

# Options that leave others without effect, or mean something only beside others.
# usage: same_with ARGS...
same_with() { ends 0 solve $scene $small --quiet "$@" -o with.csv -o with.png && same with csv png; }
rounds() {
    scene=scenes/squares.obj # whose error is found soon
    same_with --tolerance 30%
}
check "rounds of lines come out again" rounds
check "so do rounds with a bound, and the error in false colours" \
    same_with --tolerance 0.1% --lines 70000 --replicates 2 --show error
check "patches in colours of their own do" same_with --lines 5000 --show patches
check "a power per line does" same_with --lines 5000 --method extended --power-per-line 1
check "other views do" same_with --lines 5000 --eye=-1,2,3 --fov 50 --shading flat --exposure -1 --two-sided
check "lines from the box do" same_with --lines 5000 --method global --chords box --bidirectional no

odd_names() {
    cp scenes/5cubes.mtl . && for name in "my room.obj" "it's; seed: 3.obj" "-q.obj" "--quiet" '$HOME "x" <&>.obj' "Räume für €5.obj"; do
        cp scenes/5cubes.obj "./$name" && ends 0 solve $small --lines 5000 --quiet -o odd.csv -o odd.ppm -o odd.png -- "$name" &&
            same odd csv ppm png && ends 0 explain --of 4096 -o odd.svg -- "$name" && same odd svg || return
    done
}
on_posix check "scenes with blanks, quotes, semicolons, dashes and umlauts in their names are found again" odd_names
finish
