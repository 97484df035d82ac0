# Puts the style sheet and the scripts that page.html names into it, so that it needs no other file.
# usage: awk -f page.awk page.html       in the folder of these files
function put(name, element,   line) {
    print "<" element ">"
    while ((getline line < name) > 0)
        print line
    print "</" element ">"
}
/^<link rel="stylesheet"/ { split($0, part, "\""); put(part[4], "style"); next }
/^<script src=/ { split($0, part, "\""); put(part[2], "script"); next }
{ print }
