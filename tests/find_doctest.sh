# Prints the folder that holds doctest/doctest.h (nothing when the compiler finds it by itself).
# Order: $DOCTEST, the include path, else the distribution's package unpacked into BUILD/doctest without root.
# usage: find_doctest.sh BUILD
build=$1
if [ -n "$DOCTEST" ]; then
    for dir in "$DOCTEST" "$DOCTEST/include"; do
        [ -f "$dir/doctest/doctest.h" ] && { echo "$dir"; exit 0; }
    done
    # A lone doctest.h is accepted too: it gets the folder that the tests include it from.
    if [ -f "$DOCTEST/doctest.h" ]; then
        mkdir -p "$build/doctest-given/doctest" && cp "$DOCTEST/doctest.h" "$build/doctest-given/doctest/" &&
            { echo "$build/doctest-given"; exit 0; }
    fi
    echo "tests: no doctest/doctest.h in DOCTEST=$DOCTEST" >&2
    exit 1
fi
echo '#include <doctest/doctest.h>' | ${CXX:-c++} -E -x c++ - >/dev/null 2>&1 && exit 0

header=$build/doctest/usr/include
[ -f "$header/doctest/doctest.h" ] && { echo "$header"; exit 0; }
mkdir -p "$build/doctest" && folder=$(cd "$build/doctest" && pwd) || exit 1
fetch() { (cd "$folder" && apt-get "$@" download doctest-dev && dpkg-deb -x doctest-dev_*.deb .) >"$folder/log" 2>&1; }
fetch_with_own_lists() {
    mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial"
    set -- -o Dir::State::Lists="$folder/lists" -o Dir::Cache="$folder/cache"
    apt-get "$@" update >"$folder/log" 2>&1 && fetch "$@"
}
if command -v apt-get >/dev/null 2>&1 && { fetch || fetch_with_own_lists; } && [ -f "$header/doctest/doctest.h" ]; then
    rm -rf "$folder/lists" "$folder/cache"
    echo "$header"
    exit 0
fi
echo "tests: doctest is missing: install the package doctest-dev (Debian, Ubuntu), or run 'make test DOCTEST=folder-with-doctest.h'" >&2
exit 1
