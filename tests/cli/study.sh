# The study as a user runs it: curves, slopes, plot, cache, references, and what it refuses.
. "$2/tests/cli/check.sh"
scene=$root/scenes/cube.obj
few="--from 2^9 --to 2^12 --replicates 2 --patch-size 0.5"

table_and_plot() {
    ends 0 study "$scene" $few --methods global,reuse --sequences random,halton:2,7,3,5 -o a.csv -o a.svg || return
    says out "global, halton:2,7,3,5" && says out "slope -" && says out "reference: relative MSE" || return
    # 4 curves of 4 points, each row with 16 fields (the bases are quoted)
    grep -v '^#' a.csv | sed 's/"[^"]*"/Q/' | awk -F, 'NR == 1 { if ($1 $2 $3 != "methodsequencelines" || NF != 16) exit 1; next }
        { if (NF != 16 || !($7 >= 0)) exit 1; ++rows } END { exit rows != 16 }' || { cat a.csv; return 1; }
    grep -q '^# command: multipath study .*--methods global,reuse' a.csv && grep -Eq '^# scene: [0-9a-f]{16}$' a.csv &&
        grep -q '</svg>' a.svg && grep -q 'slope −' a.svg
}
check "a study prints its table and writes CSV and SVG" table_and_plot

# The first point is like a run of solve with the same option, but for its seed. The rules of a ratio are points, too: (3),
# and a pilot.
varied() {
    room="$root/scenes/4chairs-up.obj --patch-size 0.5"
    curve="--to 2^12 --replicates 1 --methods extended --sequences sobol"
    for words in "--ratios 1/4,1..4|--ratio 0.25|1,2,4,auto,measured" "--thresholds 0,0.5..2|--threshold 0|0.5,1,2"; do
        rest=${words#*|} option=${rest%|*}
        ends 0 study $room $curve ${words%%|*} -o varied.csv -o varied.svg && grep -q '</svg>' varied.svg || return
        ends 0 solve $room --lines 2^12 --method extended $option -q -o run.csv &&
            ends 0 compare run.csv varied.cache/reference-*.csv || return
        awk 'FNR == NR { if (/^MSE/) { gsub(",", ""); want = $5 } next } !/^#/ && $1 ~ /^extended/ && !done++ { split($0, f, ","); got = f[7] }
            END { exit !(got / want > 0.8 && got / want < 1.25) }' out varied.csv || { cat out varied.csv; return 1; }
        [ "$(grep -c '^extended' varied.csv)" -eq "$(echo "$option,${rest#*|}" | tr ',' '\n' | wc -l)" ] || return
    done
    ends 0 study $room --to 2^12 --methods extended --sequences random --ratios 1/16..16 --replicates 2 && says out "least error" &&
        says out "of (3)" && says out "of pilot" || return
    for wrong in "--ratios 2..1" "--ratios 0..1" "--ratios x" "--ratios 1/0" "--ratios 1 --thresholds 1" "--ratios 1 --from 2^10" \
        "--ratios 1 --ratio 2" "--thresholds 1 --threshold 2" "--ratios 1 --against seconds" "--ratios 1 --methods local" \
        "--thresholds 1 --methods global" "--ratios 1 --power-per-line 1"; do
        ends 2 study $room --to 2^10 $wrong || return
    done
}
check "a study varies the ratio and the threshold, and refuses what cannot be" varied

# The rooms of tests/families are the same whatever program runs the script.
same_rooms() {
    for family in furniture building pillars courtyard lamps; do
        for program in mawk gawk original-awk busybox; do
            command -v $program >/dev/null || continue
            [ $program = busybox ] && program="busybox awk"
            $program 'BEGIN { exit }' 2>/dev/null || continue
            $program -v family=$family -v size=10 -v seed=3 -v out=one.obj -f "$root/tests/families/room.awk" || return
            awk -v family=$family -v size=10 -v seed=3 -v out=other.obj -f "$root/tests/families/room.awk" || return
            sed 's/^mtllib.*//' one.obj >one && sed 's/^mtllib.*//' other.obj | cmp - one && cmp one.mtl other.mtl || return
        done
    done
}
check "every awk makes the same rooms" same_rooms

without_times() { sed 's/"[^"]*"/Q/' "$1" | awk -F, -v OFS=, '/^#/ || $1 == "method" { print; next } { $9 = ""; print }'; }
resumes() {
    cp a.csv before.csv && ends 0 study "$scene" $few --methods global,reuse --sequences random,halton:2,7,3,5 -o a.csv &&
        cmp a.csv before.csv || return
    # one run forgotten and one cut in two are done again, the others are taken from the cache, times included
    runs=$(ls a.cache/runs-*.txt) && sed -i '3d' "$runs" && truncate -s -5 "$runs" || return
    ends 0 study "$scene" $few --methods global,reuse --sequences random,halton:2,7,3,5 -o a.csv || return
    without_times a.csv >now && without_times before.csv >then && cmp now then
}
check "a study goes on where it was: kept runs are not repeated, lost ones are" resumes

# The kept files are made those of another program: its sources in the description, and results that nobody would get.
other_program() {
    ends 0 study "$scene" $few --methods global --sequences random -o other.csv || return
    sources=$(cd "$root" && find src -type f | LC_ALL=C sort | tr '\n' '\0' | xargs -0 cat | cksum)
    grep -q "; sources: $sources\$" other.cache/runs-*.txt && grep -qx "# sources: $sources" other.cache/reference-*.csv ||
        { head -n 5 other.cache/*; echo "the sources have $sources"; return 1; }
    without_times other.csv >right
    sed -i "s/sources: .*/sources: 1 2/" other.cache/*
    awk -F, -v OFS=, '/^[0-9]/ { $NF = 9; $(NF - 1) = 9; $(NF - 4) = 9 } { print }' "$(ls other.cache/reference-*.csv)" >bad.csv && mv bad.csv "$(ls other.cache/reference-*.csv)"
    ends 0 study "$scene" $few --methods global --sequences random -o other.csv || return
    without_times other.csv | cmp - right && [ "$(ls other.cache | wc -l)" -eq 2 ] && grep -q "; sources: $sources\$" other.cache/runs-*.txt
}
check "what a program from other sources has kept is not used" other_program

# A reference in the place of another, as if the checksums in their names were the same.
other_reference() {
    for seed in 1 2; do
        ends 0 study "$root/scenes/5cubes.obj" $few --methods global --sequences random --seed $seed -o seed$seed.csv || return
    done
    without_times seed2.csv >right
    cp seed1.cache/reference-*.csv "$(ls seed2.cache/reference-*.csv)" && rm seed2.cache/runs-*.txt
    ends 0 study "$root/scenes/5cubes.obj" $few --methods global --sequences random --seed 2 -o seed2.csv &&
        without_times seed2.csv | cmp - right
}
check "a kept reference is used only if it says of itself what it should be" other_reference

interrupted() {
    long="--methods global --sequences random --patch-size 0.5 --from 2^15 --to 2^17 --replicates 32 -o long.csv --quiet"
    "$program" study "$scene" $long --threads 1 2>err &
    pid=$!
    for wait in $(seq 2000); do
        [ "$(cat long.cache/runs-*.txt 2>/dev/null | wc -l)" -ge 4 ] && break
        sleep 0.05
    done
    kill -9 $pid; wait $pid 2>/dev/null
    kept=$(cat long.cache/runs-*.txt | wc -l)
    [ "$kept" -ge 4 ] && [ ! -f long.csv ] || { echo "kept $kept"; return 1; }
    head -4 long.cache/runs-*.txt >kept.txt
    ends 0 study "$scene" $long || return
    grep -F -x -f kept.txt long.cache/runs-*.txt | wc -l | grep -qx 4
}
check "killed in the middle, a study keeps what was finished" interrupted

# usage: left_by_signal NAME MOMENT COMMAND ARGS...    stops it once the command MOMENT succeeds; nothing half written may stay
left_by_signal() {
    name=$1 moment=$2
    shift 2
    "$program" "$@" >out 2>err &
    for wait in $(seq 2000); do
        $moment && break
        sleep 0.02
    done
    kill -TERM $!
    wait $!
    status=$?
    [ $status -eq 130 ] || { echo "exit status $status"; cat err; return 1; }
    says err "interrupted" && lines_are err 1 && [ -z "$(find . -name "*$name*.part")" ] && [ ! -f "$name" ]
}
one_kept() { [ "$(cat left.cache/runs-*.txt 2>/dev/null | wc -l)" -ge 2 ]; }
part_there() { [ -n "$(find . -name '.reference*.part')" ]; }
stopped() {
    left_by_signal left.csv one_kept study "$scene" --methods global --sequences random --patch-size 0.5 --from 2^15 --to 2^22 --replicates 100 \
        --reference ref_of_24.csv --quiet -o left.csv
}
stopped_in_reference() {
    left_by_signal reference part_there study "$scene" --methods global --from 2^24 --to 2^24 --patch-size 0.5 --quiet -o none.csv &&
        [ ! -f none.csv ]
}
check "a reference for the next" ends 0 solve "$scene" --patch-size 0.5 --lines 2^14 --quiet -o ref_of_24.csv
on_posix check "SIGTERM ends a study at once: exit status 130, kept runs kept, nothing half written" stopped
on_posix check "and so it does while the reference is computed" stopped_in_reference

more_curves() {
    ends 0 study "$scene" $few --methods global,reuse,local --sequences random,halton:2,7,3,5 --cache a.cache -o more.csv || return
    grep '^reuse' a.csv | sort >then && grep '^reuse' more.csv | sort >now && cmp now then
}
check "another study of the same runs takes them from the cache, times included" more_curves

references() {
    ends 0 solve "$scene" --patch-size 0.5 --lines 2^16 --replicates 4 --quiet -o ref.csv &&
        ends 0 study "$scene" $few --methods global --sequences sobol --reference ref.csv && says out "reference: relative MSE" &&
        ends 0 solve "$scene" --patch-size 0.5 --lines 2^16 --quiet -o plain.csv &&
        ends 0 study "$scene" $few --methods global --sequences sobol --reference plain.csv && says out "of unknown error" || return
    ends 1 study "$scene" --from 100 --to 400 --patch-size 0.25 --reference ref.csv && says err "24 patches, expected 96 as in the scene" || return
    ends 1 study "$root/scenes/furnace.obj" --from 100 --to 400 --reference "$root/tests/fixtures/reference/5cubes-grey-reference.csv" && says err "5cubes-grey-reference.csv"
}
check "a reference is read from a table, its error if it has one, and one of another scene is refused" references

near_reference() {
    ends 0 solve "$scene" --patch-size 0.5 --method local --sequence random --lines 2000 --replicates 4 --quiet -o coarse.csv &&
        ends 0 study "$scene" --patch-size 0.5 --from 2^10 --to 2^13 --methods global --sequences random --reference coarse.csv --replicates 2 -o near.csv &&
        says out "%* " && says out "too few points" || return
    grep -v '^#' near.csv | awk -F, 'NR > 1 && $12 != 0 { exit 1 } NR > 1 && $10 != "" { exit 1 }'
}
check "points near the reference's own error are marked and make no slope" near_reference

threads_agree() {
    for threads in 1 2; do
        ends 0 study "$scene" $few --methods global,reuse --sequences random,sobol --threads $threads --cache t$threads -o t$threads.csv || return
        without_times t$threads.csv >t$threads.txt
    done
    cmp t1.txt t2.txt
}
check "the study does not depend on the number of threads, times apart" threads_agree

seconds_plot() {
    ends 0 study "$scene" $few --methods global --sequences random,sobol --against seconds -o s.svg && grep -q 'seconds' s.svg
}
check "--against seconds draws the error against time" seconds_plot

refusals() {
    ends 2 study "$scene" --methods gobal && says err "got 'gobal'" || return
    ends 2 study "$scene" --sequences random,,sobol && says err "names with a comma between them" || return
    ends 2 study "$scene" --sequences random,random && says err "named twice" || return
    ends 2 study "$scene" --sequences sobl && says err "sobl" || return
    ends 2 study "$scene" --sequences 2,3 && says err "sequences" || return
    ends 2 study "$scene" --from 2^20 --to 2^14 && says err "--to: expected a count from 1048576" || return
    ends 2 study "$scene" --from 0 && says err "--from" || return
    ends 2 study "$scene" --replicates 0 && says err "--replicates" || return
    ends 2 study "$scene" --methods local --chords box && says err "no effect with --methods local" || return
    ends 2 study "$scene" --methods reuse --threshold 3 && says err "no effect" || return
    ends 2 study "$scene" -o study.png && says err ".csv, .svg" || return
    ends 2 study "$scene" --line-orders backwards && says err "shuffled" || return
    ends 1 study missing.obj --from 10 --to 20 && says err "missing.obj" || return
    : >file && ends 1 study "$scene" --cache file --from 10 --to 20 && says err "cannot make the folder" || return
    ends 1 study "$scene" --cache nowhere/cache --from 10 --to 20 && says err "cannot make the folder" || return
    ends 2 study "$scene" --reference ref.csv -o ref.csv && says err "is an input" || return
    ends 2 study "$scene" --methods global --sequences hammersley:1000 --from 2^12 --to 2^13 && says err "ends after 1000 items"
}
check "what makes no sense is refused in one line" refusals

# Points of the law 3 / lines: its slope is known.
other_programs() {
    printf 'lines,relative_mse,seconds\n1000,3e-3,0.1\n2000,1.5e-3,0.2\n4000,7.5e-4,0.4\n' >mine.csv
    ends 0 study "$scene" $few --methods global --sequences random --with mine.csv -o with.csv -o with.svg &&
        says out "mine" && says out "slope -1.000 +- 0.000" && grep -q '^mine,,1000,0,0,' with.csv && grep -q '>mine' with.svg &&
        ends 0 study "$scene" $few --methods global --sequences random --with mine.csv --against seconds -o seconds.svg -q && grep -q '>mine' seconds.svg || return
    mkdir -p other && cp mine.csv other && ends 2 study "$scene" $few --with mine.csv --with other/mine.csv && says err "two files are called" &&
        ends 2 study "$scene" $few --with mine.csv -o mine.csv && says err "is an input" &&
        ends 1 study "$scene" $few --with absent.csv && says err "absent.csv" || return
    while IFS= read -r row; do
        { echo lines,relative_mse; echo 100,1; echo "$row"; } >bad.csv
        ends 1 study "$scene" $few --with bad.csv && says err "bad.csv:3" && lines_are err 1 || { echo "$row"; return 1; }
    done <<END
0,1
100,1
50,1
200.5,1
200,0
200,-1
200,inf
1e30,1
200
END
}
check "curves of other programs stand beside those of the study" other_programs

state_reference() {
    ends 0 solve "$scene" --patch-size 0.5 --lines 2^20 -q -o equal.state &&
        ends 0 study "$scene" --methods reuse --sequences sobol-owen --from 2^14 --to 2^17 --replicates 2 --patch-size 0.5 \
            --reference equal.state -o equal.csv --quiet &&
        awk -F, '/^reuse/ { last = $7 } END { exit !(last < 1e-4) }' equal.csv &&
        ends 1 study "$scene" --methods reuse --from 2^14 --to 2^14 --patch-size 0.25 --reference equal.state &&
        lines_are err 1 && says err "equal.state: 24 patches, expected 96 as in the scene"
}
check "a state is a reference, unless it has other patches" state_reference

finish
