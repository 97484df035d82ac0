# `multipath solve -o room.html`: the page to walk through a room, as a file. What it shows: tests/browser/viewer.sh.
. "$2/tests/cli/check.sh"
cp -r "$root/scenes" .
small="--lines 5000 --patch-size 1 --quiet"

written() {
    ends 0 solve scenes/5cubes.obj $small -o room.html && silent out && silent err && head -n 1 room.html | grep -qx '<!DOCTYPE html>' &&
        tail -n 1 room.html | grep -qx '</html>' && grep -q '^<meta name="multipath" content="command: multipath solve .*--lines 5000' room.html
}
check "the page carries its command" written

alone() { ! grep -E '(src|href)="[^d"]|://|@import|url\(' room.html; }
check "it refers to nothing outside of it" alone

plain_bytes() { [ "$(tr -d '\000-\010\013-\037' <room.html | wc -c)" -eq "$(wc -c <room.html)" ]; }
check "it holds no control characters" plain_bytes

same_bytes() {
    for threads in 1 2; do
        ends 0 solve scenes/5cubes.obj $small --threads $threads -o room-$threads.html && cmp room.html room-$threads.html || return
    done
    ends 0 solve scenes/5cubes.obj $small -o beside.csv -o beside.html -o beside.png && cmp room.html beside.html
}
check "the same bytes for any number of threads, alone or beside other outputs" same_bytes

every_method() {
    for method in $(methods); do
        ends 0 solve scenes/5cubes.obj $small --method $method -o $method.html && says $method.html '"transfers"' || return
    done
}
check "every method has its page and its traces" every_method

with_error() { ends 0 solve scenes/5cubes.obj $small --replicates 2 --show error -o error.html && says error.html '"title": "Standard error of the radiosity"' && says error.html '"shown": 3'; }
check "with replicates the page knows the error, and shows it first where pictures would" with_error

few_lines() { ends 0 solve scenes/5cubes.obj --patch-size 1 --lines 3 --quiet -o few.html && says few.html '"quantities"'; }
check "few lines make no trouble" few_lines

small_file() { ends 0 solve scenes/4chairs.obj --quiet -o 4chairs.html && [ "$(wc -c <4chairs.html)" -lt 3000000 ]; }
check "4CHAIRS takes less than 3 MB" small_file

many_patches() { ends 0 solve scenes/5cubes.obj --lines 2^18 --patches 100000 --quiet -o many.html && [ "$(wc -c <many.html)" -lt 8000000 ]; }
check "100,000 patches take less than 8 MB" many_patches

written_wrong() {
    ends 2 solve scenes/5cubes.obj $small -o room.htm && says err ".html" && ends 1 solve scenes/5cubes.obj $small -o missing/room.html
}
check "a wrong extension or folder is refused" written_wrong
finish
