# The laboratory in real browsers, without a network: its results are the bytes of the program, its lessons show what they say.
# usage: lab.sh PROGRAM ROOT LAB.html [PICTURES]     in an empty folder; CHROMIUM and FIREFOX name the browsers
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1") root=$2 lab=$3 pictures=${4:-}
mkdir native && cp "$root"/scenes/*.obj "$root"/scenes/*.mtl native && ln -s "$root/scenes" scenes || exit 1
for method in $("$program" help methods | sed -n 's/^  \([a-z][a-z-]*\)  .*/\1/p'); do
    set -- solve 5cubes.obj --method "$method" --patches 600 --lines 2^12 --threads 1 -q --size 120x90 -o "$method.csv" -o "$method.png"
    printf '%s\n' "$@" >"native/$method.words"
    (cd native && "$program" "$@") || exit 1
done
for browser in ${BROWSERS:-chromium firefox}; do
    echo "$browser"
    timeout 900 node "$root/tests/browser/lab.js" "$browser" "$lab" native $pictures
done >found
cat found
echo "$(grep -c '^ok' found) passed, $(grep -c '^FAILED' found) failed"
! grep -q '^FAILED' found
