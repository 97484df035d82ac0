# `multipath explain`: single lines of a run in words and as a drawing.
. "$2/tests/cli/check.sh"
scene=$root/scenes/5cubes.obj

narrow() { ! awk 'length($0) > 110' out | grep .; }

global_lines() {
    ends 0 explain "$scene" --lines 2 --of 2^14 --ratio 1 --line-order sequence && silent err && narrow && says out "line 1 of " && says out "line 2 of " &&
        ! grep -q "line 3 of" out && says out "on the sphere" && says out "sends forecast" && says out "then holds" &&
        says out "floor (line 22) "
}
check "the first global lines are told with their crossings, pairs and powers" global_lines

rays() {
    ends 0 explain "$scene" --stage first-shot --of 2^14 && silent err && narrow && says out "ray 3 of " &&
        says out "receives" && ends 0 explain "$scene" --stage extended:2 --method extended --of 2^14 && narrow &&
        says out "pass 2 of"
}
check "rays of the first shot and of a later pass are told" rays

# Of what the lamp sends, the share 0.1998 reaches the other square (scenes/squares.obj): of 1000 rays 200, give or take
# 63, which is five standard deviations of random ones.
# usage: about COUNT TEXT
about() {
    count=$(grep -c "$2" out)
    [ "$count" -gt $(($1 - 63)) ] && [ "$count" -lt $(($1 + 63)) ] || { echo "$count times '$2' instead of $1"; return 1; }
}
lost_power() {
    cp "$root/scenes/squares.obj" "$root/scenes/squares.mtl" . && sed 's/^f 1 2 3 4/f 4 3 2 1/' squares.obj >away.obj
    rays_of="--patch-size 1 --stage first-shot --of 2^14 --lines 1000"
    ends 0 explain squares.obj $rays_of && about 800 "which is lost: it leaves the scene" && about 200 " receives " || return
    ends 0 explain away.obj --flip $rays_of && about 800 "lost: it leaves the scene" && about 200 "lost: it meets the back of a surface"
}
check "rays that leave an open scene, or meet the back of a surface, are told as lost, as many as form factors say" lost_power

particles() {
    ends 0 explain "$scene" --method local --of 2^14 --lines 20 && silent err && narrow && says out "particle 20 of " &&
        says out "it goes on with" && says out "it ends"
}
check "particles of the local method are told until they end" particles

no_length() {
    ends 0 explain "$scene" --method global --line-order sequence --lines 1 && says out "meets nothing:" &&
        ends 0 explain "$root/scenes/squares.obj" --method global --line-order sequence --lines 3 && says out "meets nothing:"
}
check "chords of length 0 and lines that meet nothing are explained as such" no_length

from_the_box() {
    ends 0 explain "$scene" --lines 2 --of 2^14 --chords box && silent err && narrow && says out "bounding box" &&
        says out "both just outside the box" && ! grep -q sphere out &&
        ends 0 explain "$scene" --stage first-shot --of 2^14 --chords box &&
        ends 0 explain "$scene" --of 2^14 --chords box -o box.svg && ! grep -q "the sphere" box.svg
}
check "lines from the box are told as such" from_the_box

later_line() {
    ends 0 explain "$scene" --of 2^14 --lines 30 && sed -n '/^line 30 of/,$p' out >last &&
        ends 0 explain "$scene" --of 2^14 --lines 1 --first 30 && sed -n '/^line 30 of/,$p' out | cmp - last && [ -s last ]
}
check "--first tells a later line with the powers that the lines before it left" later_line

skipped() {
    for run in "--method local" "--method gathering" "--stage first-shot"; do
        ends 0 explain "$scene" $run --of 2^14 --lines 2 --skip 5000 && says out " 1 of " && says out ": item 5,000 = " && says out ": item 5,001 = " || return
    done
}
check "--skip leaves out the first items, of every kind of path" skipped

grey_and_colour() {
    ends 0 explain "$root/tests/fixtures/reference/5cubes-grey.obj" --of 2^14 && ! grep -q "sends forecast (" out && says out "sends forecast" &&
        ends 0 explain "$scene" --of 2^14 && says out "sends forecast ("
}
check "a grey scene is told in one number, a coloured one in three" grey_and_colour

same_for_all_threads() {
    ends 0 explain "$scene" --of 2^14 --threads 1 && mv out one && ends 0 explain "$scene" --of 2^14 --threads 3 &&
        cmp one out
}
check "the number of threads changes nothing" same_for_all_threads

drawing() {
    for arguments in "" "--stage first-shot" "--method local --up 0,0,1" "--lines 30 --bidirectional no"; do
        ends 0 explain "$scene" --of 2^14 $arguments -o lines.svg && [ -s out ] && says lines.svg "</svg>" &&
            says lines.svg "from above" && ! grep -qE "nan|inf" lines.svg || return
    done
    command=$(sed -n 's/^.*command: multipath //p' lines.svg)
    mv lines.svg first.svg && ends 0 $command -o lines.svg && cmp lines.svg first.svg
}
check "-o draws the lines, and the drawing says how to make it again" drawing

to_stdout() {
    ends 0 explain "$scene" --of 2^14 -o lines.svg && ends 0 explain "$scene" --of 2^14 -o - && cmp out lines.svg
}
check "-o - writes the drawing to stdout instead of the text" to_stdout

# usage: refused STATUS TEXT ARGS...
refused() {
    status=$1 text=$2
    shift 2
    ends "$status" explain "$scene" --of 2^12 "$@" && silent out && lines_are err "$((status == 2 ? 2 : 1))" && says err "$text"
}
check "an unknown stage is refused" refused 2 "--stage: expected one of first-shot, global with --method first-shot, got 'firstshot'" --stage firstshot
bundle_told() {
    ends 0 explain "$scene" --method transillumination --of 2^14 --lines 5 -o bundle.svg && says out "Lines of one direction of transillumination of a run" &&
        says out "line 5 of" && says out " sends " && grep -q "line 5" bundle.svg && ends 0 explain "$scene" --method transillumination --stage first-shot --of 2^14 &&
        ends 2 explain "$scene" --method transillumination --stage global && says err "expected one of first-shot, bundle" &&
        ends 2 explain "$scene" --stage bundle && says err "expected one of first-shot, global with --method first-shot"
}
check "parallel lines of transillumination are told and drawn" bundle_told
relatives_told() {
    ends 0 explain "$scene" --method gathering --of 2^14 --lines 3 -o walks.svg && says out "Gathering random walks of a run" &&
        says out "walk 3 of" && grep -q "walk 3" walks.svg &&
        ends 0 explain "$scene" --method jacobi --of 2^14 --lines 3 -o rays.svg && says out "Rays of a stochastic Jacobi iteration of a run" &&
        says out "ray 3 of" && says out "(J2)" && grep -q "ray 3" rays.svg &&
        ends 0 explain "$scene" --method jacobi --bidirectional no --of 2^14 && says out "(J1)"
}
check "gathering walks and rays of an iteration are told and drawn" relatives_told
check "a pass that is no number is refused" refused 2 "--stage: expected a count" --method extended --stage extended:x
check "pass 0 is refused" refused 2 "--stage: expected a count" --method extended --stage extended:0
check "a first shot of the global method is refused" refused 2 "expected one of global with --method global, got 'first-shot'" --method global --stage first-shot
check "particles of another method are refused" refused 2 "got 'local'" --stage local
check "line reuse, which carries nothing along its lines, is refused" refused 2 "--method: expected one of local, global, first-shot, extended, jacobi, transillumination, gathering, got 'reuse'" \
    --method reuse
check "global lines of the local method are refused" refused 2 "expected one of local with --method local, got 'global'" --method local --stage global
check "a later pass of the plain first shot is refused" refused 2 "expected one of first-shot, global with --method first-shot, got 'extended:2'" --stage extended:2
check "a pass that does not happen is refused" refused 2 "but pass 900 is asked for" --method extended --stage extended:900
check "no lines are refused" refused 2 "--lines: expected a count" --lines 0
check "more than 1000 lines are refused" refused 2 "--lines: expected a count from 1 to 1000" --lines 1001
check "line 0 is refused" refused 2 "--first: expected a count" --first 0
check "a line beyond the last is refused" refused 2 "is asked for" --first 1M
check "an unknown sequence is refused" refused 2 "unknown sequence 'sobl'" --sequence sobl
check "an option without effect is refused" refused 2 "--ratio has no effect" --method global --ratio 1
check "chords of particles are refused" refused 2 "--chords has no effect" --method local --chords box
check "no direction up is refused" refused 2 "--up: expected a direction" --up 0,0,0
check "a picture is refused" refused 2 "expected one of .svg" -o lines.png

no_lines_at_all() { ends 2 explain "$scene" --of 0 && silent out && says err "--of: expected a count"; }
check "a run without lines is refused" no_lines_at_all
finish
