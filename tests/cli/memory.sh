# What does not fit into the memory is refused before it is tried.
. "$2/tests/cli/check.sh"
scene=$root/scenes/cube.obj

# The cube has 6 square sides of 1 m, each cut into 12904 x 12904 patches.
# usage: too_many COMMAND OPTIONS...
too_many() {
    command=$1
    shift
    ends 1 "$command" "$scene" --patch-size 7.75e-5 --memory 8GB "$@" && silent out && lines_are err 1 &&
        says err "999,079,296 patches need about 400 GB of memory, but --memory allows 8 GB"
}
check "solve refuses more patches than fit, with their number" too_many solve -o room.csv --quiet
check "and so does check" too_many check
check "and study" too_many study
check "and explain" too_many explain
finish_clean() { [ -z "$(ls -A | grep room)" ]; }
check "no output is left behind" finish_clean

machine() { ends 1 check "$scene" --patch-size 1e-9 && says err "but this machine has" && lines_are err 1; }
check "without the option the machine is the limit" machine

picture() {
    ends 1 solve "$scene" --size 16384x16384 --memory 2GB -o room.png && lines_are err 1 &&
        says err "a picture of 16384 x 16384 pixels needs about 10.7 GB"
}
check "a picture that does not fit is refused" picture

page() {
    ends 1 solve "$scene" --patches 300k --memory 150MB --size 8x8 -o room.html && lines_are err 1 &&
        says err "a page of" && says err "--memory allows 150 MB"
}
check "a page that does not fit is refused, where a table of as many patches would" page

# Of runs that were solved within 150 MB.
later_page() {
    large="--patches 300k --memory 150MB --method global --lines 1000 --quiet"
    for share in 1 2; do ends 0 solve "$scene" $large --shard $share/2 --state share$share.state || return; done
    ends 0 merge share1.state share2.state -o sum.state || return
    for command in "render sum.state" "merge share1.state share2.state"; do
        ends 1 $command -o room.html && lines_are err 1 && says err "--memory allows 150 MB" && [ ! -e room.html ] || return
    done
}
check "and so it is when states are rendered or merged" later_page

reuse() {
    ends 1 solve "$scene" --patches 300k --memory 200MB -o room.csv && lines_are err 1 &&
        says err "line reuse of 298,374 patches needs about" && says err "--memory allows 200 MB" || return
    ends 0 solve "$scene" --patches 300k --memory 200MB --lines 2^18 -o room.csv --quiet # not reused
}
check "line reuse that does not fit is refused" reuse

file() { ends 1 check "$scene" --memory 1000 && lines_are err 1 && says err "reading it needs about"; }
check "a file that does not fit is refused" file

# With pairs within the limit, and counted in rows where they are not.
# usage: within KILOBYTES OPTIONS...
within() {
    limit=$1
    shift
    (ulimit -v "$limit" && ends 0 solve "$scene" --lines 20000 --size 8x8 --threads 1 --quiet "$@")
}
# usage: copies_of NUMBER: a closed room with so many copies of a square in it
copies_of() {
    {
        cat "$root/scenes/cube.obj"
        printf 'v .2 .5 .2\nv .2 .5 .8\nv .8 .5 .8\nv .8 .5 .2\n'
        yes 'f -4 -3 -2 -1' | head -n "$1"
    } >copies.obj
}
copies() {
    cp "$root/scenes/cube.mtl" . || return
    copies_of 400
    (ulimit -v 250000 && ends 1 check copies.obj --threads 1 && says out "pairs of faces lie in one place") || return
    copies_of 4000 # of whose pairs 8 bytes each would be too many
    for method in $(methods | grep -v -e reuse -e gathering) "reuse --direct shoot"; do # few walks gather nothing
        (ulimit -v 145000 && ends 0 solve copies.obj --patches 4100 --lines 300 --method $method --threads 1 -o copies.csv --quiet) || return
    done
}
# A sanitizer takes all addresses there are.
if (ulimit -v 300000 && "$program" --version >/dev/null 2>&1); then
    check "a run keeps to its estimate without pairs" within 140000 --patches 200k --memory 95MB -o a.csv -o a.png -o a.glb
    check "hundreds and thousands of copies of a face take no more than the scene" copies
    check "and the pairs of reuse to the limit" within 250000 --patches 8000 --memory 200MB -o b.csv
    counts() { (ulimit -v 100000 && ends 0 solve "$scene" --patches 50k --lines 2^23 --memory 60MB --threads 1 --quiet -o c.csv); }
    check "and the counts of many lines, in parts" counts
    many_rays() { (ulimit -v 140000 && ends 0 solve "$root/scenes/5cubes.obj" --patch-size 0.5 --lines 2^24 --threads 1 --quiet -o d.csv); }
    check "and the rays of pairs, however many they are" many_rays
fi
finish
