# Feeds made-up bytes to everything that reads what others wrote: SECONDS for each tests/fuzz/NAME_fuzz.cpp, from the
# examples in tests/fuzz/corpus/NAME on. Ends with the line "N passed, N failed". What makes a target crash, hang or
# take a gigabyte is kept as build/fuzz/NAME-crash-..., and `build/fuzz/NAME_fuzz FILE` shows it again.
# CXX may name another clang++, BUILD a folder of objects, which the fuzzer explores as far as they were compiled for it.
# Without a clang++ there is nothing to run and nothing fails.
# usage: run.sh SECONDS [NAME...]
[ $# -ge 1 ] || { echo "usage: run.sh SECONDS [NAME...]" >&2; exit 2; }
seconds=$1
shift
cd "$(dirname "$0")/../.." || exit 1
compiler=${CXX:-clang++}
build=${BUILD:-build/fuzz}
command -v "${compiler##* }" >/dev/null || { echo "skipped: fuzzing needs clang++"; exit 0; }
[ $# -gt 0 ] || set -- $(ls tests/fuzz | sed -n 's/_fuzz\.cpp$//p')

for name; do
    make CXX="$compiler" BUILD=$build "$build/${name}_fuzz" \
        CXXFLAGS="-O1 -g1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all" || exit 1
done

fuzz() {
    # The corpus of former runs is where this one goes on; new finds go there and not among the sources.
    mkdir -p "$build/corpus/$1"
    "$build/${1}_fuzz" "$build/corpus/$1" "tests/fuzz/corpus/$1" -max_total_time="$seconds" -rss_limit_mb=1024 -timeout=10 \
        -max_len=4096 -print_final_stats=1 -artifact_prefix="$build/$1-" >"$build/$1.log" 2>&1 </dev/null
    echo $? >"$build/$1.status"
}

# As many at a time as there are processors.
processors=$(nproc 2>/dev/null || echo 1) running=0
for name; do
    fuzz "$name" &
    running=$((running + 1))
    [ $((running % processors)) -eq 0 ] && wait
done
wait

passed=0 failed=0
for name; do
    if [ "$(cat "$build/$name.status")" = 0 ]; then
        passed=$((passed + 1))
        echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$build/$name.log") inputs, no crash"
    else
        failed=$((failed + 1))
        echo "FAILED: $name"
        tail -n 40 "$build/$name.log"
    fi
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
