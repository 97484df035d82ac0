# `multipath reproduce`: the command in a file's header, run again.
. "$2/tests/cli/check.sh"
cp -r "$root/scenes" .
TMPDIR=$PWD/tmp && export TMPDIR && mkdir tmp
scene=scenes/5cubes.obj
small="--patch-size 1 --size 40x30"

# Is the only line of stdout that the file is reproduced, byte for byte?
# usage: same FILE ARGS...
same() {
    ends 0 reproduce "$@" && lines_are out 1 && says out "$1: reproduced, the same "
}

# Does the file come out differently, and is this said?
# usage: other TEXT FILE ARGS...
other() {
    text=$1
    shift
    ends 1 reproduce "$@" && says out "$1: not reproduced" && says out "$text"
}

# usage: refused TEXT FILE
refused() {
    ends 1 reproduce "$2" --quiet && silent out && lines_are err 1 && says err "multipath: $1"
}

"$program" solve $scene $small --lines 5000 --quiet -o room.csv -o room.png -o room.ppm -o room.pfm \
    -o room.ply -o room.glb -o room.obj
for file in room.csv room.png room.ppm room.ply room.glb room.obj; do
    check "what solve has written comes out again: $file" same $file
done
check "so it does with one thread" same room.csv --threads 1

points() {
    ends 0 points --dims 3 --count 64 --sequence sobol-owen -o points.csv -o points.svg && same points.csv && same points.svg &&
        ends 0 points --count 16 --discrepancy -o even.csv && same even.csv &&
        ends 0 points --figure 2 --count 100 -o figure.svg && same figure.svg
}
check "points come out again, as tables and drawings, and nothing else comes to stdout" points

explain() {
    for arguments in "" "--stage extended:2 --method extended --threads 2" "--method local --up 0,0,1"; do
        ends 0 explain $scene --of 4096 $arguments -o lines.svg && same lines.svg || return
    done
}
check "drawings of single lines come out again, without their text on stdout" explain

study() {
    ends 0 study $scene --patch-size 1 --from 2^8 --to 2^10 --replicates 2 --methods extended,reuse --quiet -o study.csv -o study.svg &&
        same study.svg && ends 0 reproduce study.csv && lines_are out 1 && says out "study.csv: reproduced" || return
    awk -F, -v OFS=, '/^(extended|reuse),/ { $9 = 1234 } 1' study.csv >slow.csv && ends 0 reproduce slow.csv &&
        says out "slow.csv: reproduced; times differ" && [ "$(ls -d ./*.cache)" = ./study.cache ]
}
check "a study comes out again but for its times, computed anew" study

with_reference() {
    ends 0 study $scene --patch-size 1 --from 2^8 --to 2^10 --replicates 2 --methods global --reference room.csv --quiet -o by-room.svg &&
        same by-room.svg && mv room.csv away.csv || return
    refused "room.csv: cannot be opened: No such file or directory; the paths in the record of by-room.svg start where" by-room.svg
    found=$?
    mv away.csv room.csv
    return $found
}
check "a study against a table needs the table again" with_reference

against_seconds() {
    ends 0 study $scene --patch-size 1 --from 2^8 --to 2^10 --replicates 2 --methods global --against seconds --quiet -o seconds.svg -o seconds.csv &&
        sed 's/<circle/<ellipse/;s/font-size="11"/font-size="12"/' seconds.svg >changed.svg &&
        ends 1 reproduce changed.svg && lines_are out 1 && says out "seconds across" && ends 0 reproduce seconds.csv
}
check "a plot with seconds across cannot be compared, and this is said; its table can" against_seconds

# Options that leave others without effect, or mean something only beside others.
# usage: same_with ARGS...
same_with() {
    ends 0 solve $scene $small --quiet "$@" -o with.png && same with.png
}
check "rounds of lines come out again" same_with --tolerance 30%
check "so do rounds with a bound" same_with --tolerance 0.1% --lines 70000 --replicates 2
check "the error in false colours does" same_with --lines 5000 --replicates 2 --show error
check "patches in colours of their own do" same_with --lines 5000 --show patches
check "a power per line does" same_with --lines 5000 --method extended --power-per-line 1
check "other views do" same_with --lines 5000 --eye=-1,2,3 --fov 50 --shading flat --exposure -1 --two-sided
check "lines from the box do" same_with --lines 5000 --method global --chords box --bidirectional no

odd_names() {
    cp scenes/5cubes.mtl . && for name in "my room.obj" "it's; seed: 3.obj" "-q.obj" "--quiet" '$HOME "x" <&>.obj' "Räume für €5.obj" "a
b.obj"; do
        cp scenes/5cubes.obj "./$name" && ends 0 solve $small --lines 5000 --quiet -o odd.csv -o odd.ppm -o odd.png -- "$name" &&
            same odd.csv && same odd.ppm && same odd.png && ends 0 explain --of 4096 -o odd.svg -- "$name" && same odd.svg || return
    done
}
check "scenes with blanks, quotes, semicolons, dashes, umlauts and line ends in their names are found again" odd_names

changed_digit() {
    awk -F, -v OFS=, '$1 == 5 { $17 = $17 * 1.01 } 1' room.csv >changed.csv &&
        other "1 of 1,710 cells differs, line 11, column radiosity_r: then " changed.csv && lines_are out 1 && says out "relative difference 0.0099"
}
check "a changed digit of a table is found, and its cell named" changed_digit

changed_picture() {
    printf '\377\000\377' | dd of=room.ppm bs=1 seek=2000 conv=notrunc 2>/dev/null && other "pixel" room.ppm && says out "1,200" &&
        printf '\252' | dd of=room.png bs=1 seek=1000 conv=notrunc 2>/dev/null && other "compressed" room.png &&
        sed 's/stroke-width="1.2"/stroke-width="1.3"/' lines.svg >changed.svg && other 'line 14 differs: then `troke-width="1.3"' changed.svg
}
check "changed pictures and drawings are found" changed_picture

changed_scene() {
    cp scenes/5cubes.mtl 5cubes.mtl.first && sed 's/Kd 0.8/Kd 0.7/' 5cubes.mtl.first >scenes/5cubes.mtl &&
        other "the scene has changed: then '" room.csv && says out "cells differ, first " && other "the scene has changed" lines.svg
    found=$?
    mv 5cubes.mtl.first scenes/5cubes.mtl
    return $found
}
check "a changed scene is named as the reason" changed_scene

another_version() {
    sed '1s/.*/# multipath 0.0.1/' room.csv >version.csv && ends 0 reproduce version.csv && says out "reproduced, apart from its record" &&
        says out "then 'multipath 0.0.1'" && awk -F, -v OFS=, '$1 == 5 { $17 = 1 } 1' version.csv >both.csv &&
        other "1 of 1,710 cells" both.csv && says out "another version: then 'multipath 0.0.1', now 'multipath "
}
check "another version is told, and alone is no other result" another_version

kept() {
    same room.csv --keep kept.csv && cmp kept.csv room.csv && says err "wrote      kept.csv" &&
        ends 2 reproduce room.csv --keep ./room.csv && says err "is the file to compare with" &&
        ends 2 reproduce room.csv --keep $scene && says err "is an input of the command" &&
        ends 2 reproduce room.csv --keep ${scene%.obj}.mtl && says err "is an input of the command" &&
        ends 2 reproduce room.csv --keep - && ends 1 reproduce room.csv --keep none/kept.csv && says err "cannot write none/kept.csv" &&
        cmp kept.csv room.csv && ends 0 check $scene
}
check "--keep leaves the new file, but nowhere where it would do harm" kept

quiet() { same room.csv --quiet && silent err && same room.csv && says err "running    multipath solve scenes/5cubes.obj "; }
check "--quiet leaves stderr empty; without it the command is shown" quiet

elsewhere() {
    mkdir elsewhere && cd elsewhere || return
    refused "scenes/5cubes.obj: cannot be opened: No such file or directory; the paths in the record of ../room.csv start where" ../room.csv
    found=$?
    cd ..
    return $found
}
check "a scene that is not found is named, with where it is looked for" elsewhere

# usage: recording COMMAND TEXT
recording() {
    sed "s|^# command: .*|# command: $1|" room.csv >hostile.csv && refused "hostile.csv: $2" hostile.csv && [ ! -e stolen.csv ]
}
check "a file without a record is refused" refused "scenes/5cubes.obj: no record of a multipath command" scenes/5cubes.obj
check "so is a PFM, which can have none" refused "room.pfm: a PFM keeps no record" room.pfm
check "so is a file that is missing" refused "none.csv: cannot be read" none.csv
check "and a folder" refused "scenes: cannot be read" scenes
check "another program is not run" recording "touch stolen.csv" "expected a multipath command in its record, got \`touch stolen.csv\`"
check "nor a second command" recording "multipath points; touch stolen.csv" "expected a command of plain and quoted words"
check "nor an unknown command" recording "multipath steal x" "expected a multipath command that writes files (solve, render, merge, study, paper, points, explain, selftest), got 'steal'"
check "nor one that writes nothing" recording "multipath check $scene" "expected a multipath command that writes files"
check "nor reproduce itself" recording "multipath reproduce hostile.csv" "expected a multipath command that writes files"
check "nothing is written where a record says" recording "multipath points -o stolen.csv" "the command in its record has --output"
check "nor kept" recording "multipath study $scene --cache=stolen.csv" "the command in its record has --cache"
check "an unknown option is refused" recording "multipath points --steal 3" "the command in its record is refused: unknown option '--steal'"
check "a value that is none is refused" recording "multipath points --count 0" "the command in its record is refused: --count: expected a count"
check "a report is no table" recording "multipath paper" "'multipath paper' does not write such a file"

no_traces() { [ -z "$(ls -A tmp)" ] && ! ls -A | grep '\.part$'; }
check "nothing is left in the folder for temporary files" no_traces

no_folder() {
    TMPDIR=none ends 1 reproduce room.csv --quiet && lines_are err 1 && says err "cannot make a folder in none: No such file" &&
        TMPDIR=- ends 1 reproduce room.csv --quiet && mkdir -- "--odd folder" && TMPDIR="--odd folder" same room.csv
}
check "a folder for temporary files that is missing is named, one with an odd name is no problem" no_folder
finish
