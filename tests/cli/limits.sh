# Every option of every command with values at the limits of what numbers can be: it works, or it is refused in plain
# words; nothing crashes, hangs or takes all memory.
. "$2/tests/cli/check.sh"
scene=$root/scenes/cube.obj
cp "$scene" "$root/scenes/cube.mtl" .
echo "no scene" >5cubes # so that `paper` ends with its first study
"$program" solve cube.obj --lines 1000 --patches 100 --quiet -o result.csv --state result.state || exit 1
for share in 1 2; do
    "$program" solve cube.obj --lines 2000 --patches 100 --quiet --method global --shard $share/2 \
        --state share$share.state -o share.csv || exit 1
done
command -v timeout >/dev/null && patience="timeout 60" # seconds

# What makes a run of the command short, one word each.
small_run() {
    case $1 in
    solve) echo cube.obj --lines=1000 --size=8x8 --samples=1 --patches=100 --output=out.png --quiet ;;
    check) echo cube.obj --lines=1000 --patches=100 ;;
    study) echo cube.obj --from=100 --to=200 --patches=100 --replicates=2 --methods=global --sequences=sobol \
        --output=out.svg --quiet ;;
    paper) echo --output=paper --quiet ;;
    compare) echo result.csv result.csv ;;
    render) echo result.state --size=8x8 --samples=1 --output=out.png --quiet ;;
    merge) echo share1.state share2.state --size=8x8 --samples=1 --output=out.png --quiet ;;
    points) echo --count=100 --output=out.csv ;;
    explain) echo cube.obj --of=1000 --patches=100 ;;
    esac
}

# What the option needs beside it to have an effect.
needs() {
    case $1 in
    ratio | power-per-line | threshold | steps) echo --method=extended ;;
    estimator) echo --method=local ;;
    save-every) echo --state=saved.state --resume ;;
    gather-rays) echo --shading=gather ;;
    esac
}

# The options that take a value, from the help.
valued_options() { "$program" "$1" --help | sed -n 's/^  \(-., \|    \)--\([a-z-]*\) [A-Z].*/\2/p'; }

# May the work fail, for a file that is not there or a memory of two bytes?
may_fail() {
    case $1:$2 in
    paper:* | *:output | *:cache | *:reference | *:with | *:state | *:from | *:from-state | *:memory | *:patch-size | *:camera | *:important) ;;
    *) return 1 ;;
    esac
}

# usage: survives COMMAND OPTION VALUE ARGS...
survives() {
    command=$1 option=$2 value=$3
    shift 3
    $patience "$program" "$command" "$@" "--$option=$value" >out 2>err </dev/null
    status=$?
    case $status in
    0) return ;;
    1) may_fail "$command" "$option" && lines_are err 1 && return ;;
    2) silent out && lines_are err 2 && return ;;
    esac
    echo "--$option='$value' ends with exit status $status:"
    cat err
    return 1
}

# usage: small_run_without OPTION COMMAND      the words of a small run without the option, which is about to be set
small_run_without() {
    for word in $(small_run "$2") $([ "$2" = study ] || needs "$1"); do
        case $1:$word in patch-size:--patches=*) continue ;; esac
        case $word in --"$1"=*) ;; *) echo "$word" ;; esac
    done
}

all_survive() {
    options=$(valued_options "$1")
    [ "$options" ] || return
    failed=0
    for name in $options; do
        words=$(small_run_without "$name" "$1")
        for limit in 0 -1 2^63 2^64 nan '' 1e308 1e-300,1e308,inf; do
            survives "$1" "$name" "$limit" $words || failed=1
        done
    done
    return $failed
}
for name in $("$program" --help | sed -n 's/^  \([a-z][a-z]*\)  .*/\1/p'); do
    case $name in selftest | help) continue ;; esac # an exam is long, whatever the options; no option of help has a value
    check "$name survives all limits of numbers" all_survive "$name"
done

# Wrong usage that only the scene brings to light.
# usage: late_usage TEXT OPTIONS...
late_usage() {
    text=$1
    shift
    ends 2 solve cube.obj --patches 100 --quiet -o late.png "$@" && silent out && lines_are err 2 &&
        says err "$text" && [ -z "$(ls -A | grep late)" ]
}
check "a camera in the middle of what it looks at" late_usage "same point" --eye 0.5,0.5,0.5
check "a camera that looks upwards" late_usage "up direction" --eye 0.5,0.1,0.5
check "a camera beyond all distances" late_usage "too far" --eye 1e300,0,0
check "a picture with a side too long" late_usage "from 1 to 16384 pixels" --size 16385x1
check "a sequence that is too short" late_usage "ends after 1 items" --sequence hammersley:1
check "a sequence that ends" late_usage "ends after" --skip 2^48 --sequence hammersley:1000
check "more replicates than lines" late_usage "expected more lines" --lines 3 --replicates 4
check "more lines than reuse counts" late_usage "expected fewer" --lines 2^33
check "lines too few to meet a source" late_usage "1 lines found no light on any surface" --lines 1 --method global
late_trace() { ends 2 explain cube.obj --of 1000 --first 1M && says err "this stage has"; }
check "a line that the run does not have" late_trace
finish
