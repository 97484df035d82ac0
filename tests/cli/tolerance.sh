# How exact a result is: what --replicates and --tolerance tell and do.
. "$2/tests/cli/check.sh"
scene=$root/scenes/5cubes.obj

few_lines() {
    scene=$root/scenes/squares.obj
    ends 0 solve "$scene" --patches 400 --lines 80000 --replicates 4 -o few.csv && says err "64 lines per patch" || return
    ends 0 solve "$scene" --patches 400 --lines 120000 --replicates 4 -o more.csv && ! grep -q "64 lines per patch" err || return
    ends 0 solve "$scene" --patches 400 --tolerance 50% -o tolerance.csv && ! grep -q "64 lines per patch" err || return
    ends 0 solve "$scene" --patches 400 --lines 8000 --replicates 4 --method local -o local.csv && ! grep -q "64 lines" err
}
check "an error from few lines per patch is not trusted" few_lines

# usage: number KEY: of the last run with --json
number() { sed -n "s/^ *\"$1\": \([-0-9.e]*\),*$/\1/p" out; }
at_most() { awk "BEGIN { exit !($1 <= $2) }"; }
tolerance() {
    for share in 0.05 0.008; do
        ends 0 solve "$scene" --tolerance $share --json -o tolerance.csv --state $share.state && at_most "$(number error)" $share &&
            says err "% of the mean (patches " && grep -q "^# command: .* --tolerance $share" tolerance.csv &&
            ! grep -q "^# command: .*--adaptive" tolerance.csv || return
        eval "patches_$(echo $share | tr . _)=$(number patches)"
    done
    [ "$patches_0_05" -lt "$patches_0_008" ] || return
    ends 0 solve "$scene" --tolerance 0.05 --state 0.05.state --resume &&
        ends 1 solve "$scene" --tolerance 0.008 --state 0.05.state --resume && says err "patches, not" &&
        ends 0 solve "$root/scenes/squares.obj" --patches 50 --tolerance 1e-4 --lines 2^14 --json -o fixed.csv &&
        at_most 1e-4 "$(number patch_error)" && says err "above the tolerance of 0.01 %: there are too few patches"
}
check "a tolerance is one of the whole error, and chooses the patches" tolerance

out_of_reach() {
    ends 0 solve "$root/scenes/4chairs-up.obj" --tolerance 0.01% --time 4s --json -o short.png && [ -s short.png ] &&
        says err "above the tolerance of 0.01 %: there are too few patches, because of options, of the time"
}
check "a tolerance that takes longer than --time leaves the best result so far" out_of_reach
finish
