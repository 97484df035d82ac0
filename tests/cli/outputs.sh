# Outputs are complete or not there at all, whatever happens to the disk, the folder, the reader or the program.
. "$2/tests/cli/check.sh"
scene=$root/scenes/cube.obj
fine="--lines 1000 --patches 2000 --size 64x64 --quiet"
quick="--lines 1000 --patches 100 --size 8x8 --quiet"

# Is this folder as it was made: with `old` in a.csv and nothing else?
untouched() {
    [ "$(cat "$1/a.csv")" = old ] && [ "$(ls -A "$1")" = a.csv ] && return
    echo "the folder $1 has changed:"
    ls -lA "$1"
    return 1
}
with_old_file() { mkdir "$1" && echo old >"$1/a.csv"; }

full_device() {
    with_old_file device && ln -s /dev/full full.csv && ends 1 solve "$scene" $quick -o device/a.csv -o full.csv || return
    says err "cannot write full.csv: No space left on device" && lines_are err 1 && untouched device
}
[ -c /dev/full ] && on_posix check "a full device is reported, and no other output is written" full_device

# A limit on the size of files stands for a full disk: the write fails, and no signal ends the program.
large_file() {
    with_old_file large && (ulimit -f 200 && ends 1 solve "$scene" $fine -o large/a.csv) || return
    says err "cannot write large/a.csv: File too large" && lines_are err 1 && untouched large
}
on_posix check "a file that cannot grow leaves the old one as it was" large_file

one_of_several() {
    with_old_file several &&
        (ulimit -f 200 && ends 1 solve "$scene" $fine -o several/b.ppm -o several/a.csv) &&
        lines_are err 1 && untouched several
}
on_posix check "of several outputs none is written when one cannot be" one_of_several

small_disk() {
    mkdir disk && mount -t tmpfs -o size=64k tmpfs disk 2>mount.log || return 0
    echo old >disk/a.csv
    ends 1 solve "$scene" $fine -o disk/b.ppm -o disk/a.csv && says err "No space left on device" &&
        lines_are err 1 && untouched disk
    set -- $?
    umount disk
    return "$1"
}
[ "$(id -u)" = 0 ] && on_posix check "a full disk leaves the old files as they were" small_disk

locked_folder() {
    with_old_file locked && chmod 555 locked && ends 1 solve "$scene" $quick -o locked/b.csv -o b.csv || return
    chmod 755 locked
    says err "cannot write locked/b.csv: Permission denied" && untouched locked && [ ! -e b.csv ]
}
[ "$(id -u)" = 0 ] || check "a folder that may not be written is reported before the work" locked_folder

# Runs in the background with so many lines that it does not end by itself.
begin_endless() {
    "$program" solve "$scene" --patches 100 --lines 2^40 --method local --quiet "$@" 2>err &
    run=$!
    for tries in 1 2 3 4 5 6 7 8 9 10; do
        [ "$(ls -A parts)" ] && return
        sleep 0.3
    done
    echo "no output was begun"
    return 1
}
end_endless() {
    kill -KILL $run
    wait $run 2>/dev/null
    :
}

vanished_folder() {
    mkdir gone && "$program" points --count 300000 --dims 6 -o gone/a.csv 2>err &
    run=$!
    for tries in 1 2 3 4 5 6 7 8 9 10; do
        [ "$(ls -A gone 2>/dev/null)" ] && break
        sleep 0.05
    done
    rm -rf gone
    wait $run
    [ $? -eq 1 ] && says err "cannot write gone/a.csv: No such file or directory" && lines_are err 1 && [ ! -e gone ]
}
check "a folder that vanishes during the work is reported" vanished_folder

# Closed streams.
closed_output() {
    "$program" check "$scene" --lines 1000 >&- 2>err
    [ $? -eq 1 ] && says err "cannot write standard output" && lines_are err 1
}
check "a closed standard output is an error when something is to be printed" closed_output

closed_but_not_needed() { "$program" solve "$scene" $quick -o unneeded.csv >&- 2>err && silent err && [ -s unneeded.csv ]; }
check "and none when nothing is" closed_but_not_needed

help_to_nowhere() {
    "$program" --help >/dev/full 2>err
    [ $? -eq 1 ] && says err "cannot write standard output: No space left on device"
}
[ -c /dev/full ] && on_posix check "a help that nobody gets to read is an error" help_to_nowhere

# Without further care the output would get the number of a closed stream, and what is printed would end in it.
nothing_strange() {
    ends 0 solve "$scene" $quick -o expected.csv || return
    "$program" solve "$scene" --lines 1000 --patches 100 -o first.csv -o second.csv -o strange.csv 0<&- >&- 2>&-
    "$program" compare strange.csv expected.csv --tolerance 0 && [ "$(wc -l <strange.csv)" -eq "$(wc -l <expected.csv)" ]
}
on_posix check "without any standard stream nothing strange lands in an output" nothing_strange

short_reader() {
    { "$program" points --count 10M 2>err; echo $? >status; } | head -n 1 >out
    lines_are out 1 && silent err && [ "$(cat status)" = 1 ]
}
check "a reader who leaves ends the program quietly" short_reader

reader_of_text() {
    mkdir reader && { "$program" explain "$scene" --lines 1000 --of 1M -o reader/a.svg 2>err; } | head -n 1 >out
    silent err && [ "$(ls -A reader)" = a.svg ]
}
check "and does not cost the files" reader_of_text

# Inputs stay what they are.
inputs() {
    mkdir inputs && cp "$scene" inputs/a.obj && sed 's/cube\.mtl/lib.svg/' "$scene" >inputs/a.obj &&
        cp "$root/scenes/cube.mtl" inputs/lib.svg && cp "$root/scenes/cube.mtl" inputs/lib.csv || return
    printf 'mtllib lib.csv\n' >>inputs/a.obj
    ln inputs/a.obj inputs/hard.obj && ln -s a.obj inputs/soft.obj && ln -s lib.csv inputs/soft.csv
    for output in a.obj hard.obj soft.obj lib.csv soft.csv; do
        ends 2 solve inputs/a.obj $quick -o inputs/$output && says err "is an input" || return
    done
    ends 2 explain inputs/a.obj --of 1000 -o inputs/lib.svg && says err "is an input" || return
    ends 2 study inputs/a.obj --from 100 --to 100 -o inputs/lib.csv && says err "is an input" || return
    cmp inputs/lib.svg "$root/scenes/cube.mtl" && cmp inputs/lib.csv "$root/scenes/cube.mtl" &&
        [ "$(ls -A inputs | wc -l)" -eq 6 ]
}
check "no input is overwritten, neither by another name nor as a material file" inputs

# The folder holds a scene whose default pictures would have the names of its textures: one that is read, and two that are
# missing and would be found next time.
textures() {
    mkdir textures && cd textures && sed 's/cube\.mtl/a.mtl/' "$scene" >a.obj &&
        sed '/^Kd/a map_Kd A.ppm\nmap_Ke c:\\old\\Missing.ppm\nmap_d not_there.ppm' "$root/scenes/cube.mtl" >a.mtl || return
    printf 'P3 1 1 255 128 128 128\n' >a.ppm && cp a.ppm old && cp a.obj a.csv
    ln -s a.ppm soft.png && ln a.ppm hard.svg
    few="--lines 1000 --patches 100 --size 8x8 --quiet"
    ends 2 solve a.obj $few && says err "'a.ppm' is an input" || return
    ls -A >../before
    for output in ./a.ppm A.PPM ../textures/a.ppm soft.png missing.ppm not_there.ppm; do
        ends 2 solve a.obj $few -o $output && says err "is an input" || return
    done
    ends 2 explain a.obj --of 1000 -o hard.svg && says err "is an input" || return
    ends 2 selftest a.csv -o a.csv && says err "is an input" || return
    ls -A >../after && cmp ../before ../after && cmp a.ppm old || return
    ends 0 solve a.obj $few --state a.state -o a.glb && ends 2 render a.state --quiet &&
        says err "'a.ppm' is an input" && ends 2 render a.state --quiet -o missing.ppm && says err "is an input" || return
    for k in 1 2; do ends 0 solve a.obj $few --shard $k/2 --state $k.state || return; done
    ends 2 merge 1.state 2.state --quiet && says err "'a.ppm' is an input" && cmp a.ppm old
}
check "nor as a texture, present or missing, by whatever name, not even from a state" textures

camera_files() {
    printf '{"eye": [0.5, 0.5, 0.1], "target": [0.5, 0.5, 0.9]}' >view.csv && cp view.csv old
    ends 2 solve "$scene" $quick --camera view.csv -o view.csv && says err "is an input" || return
    ends 0 solve "$scene" $quick --state view.state -o view.ppm && ends 2 render view.state --camera view.csv -o view.csv &&
        says err "is an input" && cmp view.csv old
}
check "nor as a camera" camera_files

one_link_twice() {
    ln -s twice.csv link.csv && ends 2 solve "$scene" $quick -o twice.csv -o link.csv && says err "is named twice"
}
on_posix check "a file and a link to it are one output" one_link_twice
finish
