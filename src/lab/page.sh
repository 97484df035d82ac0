# Makes the page of the laboratory: one file that holds the program as WebAssembly, the bundled rooms, the lessons, and the
# viewer's page around them. Writes it to standard output.
# usage: page.sh FOLDER       at the top of the sources; FOLDER holds multipath.js and multipath.wasm
lab=src/lab made=$1

# The content of a text file as a JSON string.
json_text() {
    printf '"' && tr -d '\r' <"$1" | sed 's/[\"]/\\&/g; s/	/\\t/g; s/$/\\n/' | tr -d '\n' && printf '"'
}

rooms() {
    printf '{' && separator=
    for file in scenes/*.obj scenes/*.mtl; do
        grep -q '^map_' "${file%.*}.mtl" && continue # the page holds no textures
        printf '%s"%s":' "$separator" "${file#scenes/}" && json_text "$file" && separator=,
    done
    echo '}'
}

lessons() {
    printf '[' && separator=
    for file in "$lab"/lessons/*.json; do
        name=${file##*/}
        printf '%s{"key":"%s",' "$separator" "${name%.json}" && sed '1s/^{//' "$file" && separator=,
    done
    echo ']'
}

# The formulas of the documents by their labels.
formulas() {
    awk -F ' [|] ' 'BEGIN { printf "{" } /^[|] [(]/ { gsub(/["\\]/, "\\\\&"); printf "%s\"%s\":\"%s\"", separator, substr($1, 3), $2; separator = "," }
        END { print "}" }' docs/equations.md
}

packed() { gzip -9 -n | base64 | tr -d '\n' && echo; }

rooms >"$made/rooms.json" && lessons >"$made/lessons.json" && formulas >"$made/formulas.json" && cat "$made/multipath.js" $lab/worker.js | packed >"$made/worker.txt" &&
    packed <"$made/multipath.wasm" >"$made/program.txt" || exit 1

# Puts into the viewer's page what the laboratory adds.
awk -v lab="$lab" -v made="$made" '
function put(name,   line) {
    while ((getline line < name) > 0)
        print line
    close(name)
}
function data(id, type, name) { printf "<script type=\"%s\" id=\"%s\">", type, id; put(made "/" name); print "</script>" }
/Content-Security-Policy/ {
    print
    getline
    print "  content=\"default-src \047none\047; script-src \047unsafe-inline\047 \047wasm-unsafe-eval\047 blob:; worker-src blob:;"
    print "  style-src \047unsafe-inline\047; img-src data: blob:\">"
    next
}
/^<!-- head -->/ { print "<title>multipath laboratory</title>"; next }
/^<\/style>/ { put(lab "/lab.css") }
/^<main/ { put(lab "/panel.html") }
/^<!-- room -->/ {
    data("rooms", "application/json", "rooms.json")
    data("lessons", "application/json", "lessons.json")
    data("formulas", "application/json", "formulas.json")
    data("worker", "text/plain", "worker.txt")
    data("program", "text/plain", "program.txt")
    next
}
/^<\/body>/ {
    n = split("settings solver curve lesson who lab_controls lab", names, " ")
    for (k = 1; k <= n; ++k) {
        print "<script>"
        put(lab "/" names[k] ".js")
        print "</script>"
    }
}
{ print }' "$made/generated/viewer/page.html"
