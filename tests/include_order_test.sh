# usage: include_order_test.sh PROGRAM ROOT, in a folder of its own
. "$2/tests/cli/check.sh"

order() { sh "$root/tests/include_order.sh" "$@"; }

check "every include points down or stays in its room" order "$root/src"

# A tree of one file that includes one other.
# usage: tree FILE LINE
tree() {
    rm -rf tree && mkdir -p "tree/$(dirname "$1")" && printf '#pragma once\n%s\n' "$2" >"tree/$1"
}
allowed() { tree "$1" "$2" && order tree; }
forbidden() {
    tree "$1" "$2"
    order tree >complaint && return 1
    [ "$(cat complaint)" = "$3" ] || { cat complaint; return 1; }
}
check "a file may include its own room" allowed geometry/line.h '#include "geometry/vec3.h"'
check "a file may include a room below" allowed study/paper.h '#include "image/camera.h"'
check "main.cpp may include the top room" allowed main.cpp '#include "commands/commands.h"'
check "the standard library may be included" allowed parallel/team.h '#include <sys/stat.h>'
check "geometry knows nothing of light" forbidden geometry/line.h '#include "scene/rgb.h"' \
    "tree/geometry/line.h:2: room 'geometry' may not include 'scene/rgb.h'"
check "sampling knows nothing of scenes" forbidden sampling/warp.cpp '  #  include "scene/rgb.h" // why' \
    "tree/sampling/warp.cpp:2: room 'sampling' may not include 'scene/rgb.h'"
check "pictures and the solver do not know each other" forbidden image/png.cpp '#include "radiosity/run/solve.h"' \
    "tree/image/png.cpp:2: room 'image' may not include 'radiosity/run/solve.h'"
check "the viewer does not know how the room was solved" forbidden viewer/viewer_page.cpp '#include "radiosity/run/solve.h"' \
    "tree/viewer/viewer_page.cpp:2: room 'viewer' may not include 'radiosity/run/solve.h'"
check "no room includes the command line" forbidden study/paper.h '#include "commands/commands.h"' \
    "tree/study/paper.h:2: room 'study' may not include 'commands/commands.h'"
check "angle brackets are no way around" forbidden geometry/line.h '#include <scene/rgb.h>' \
    "tree/geometry/line.h:2: room 'geometry' may not include 'scene/rgb.h'"
check "an include names its room" forbidden geometry/line.h '#include "vec3.h"' \
    "tree/geometry/line.h:2: room 'geometry' may not include 'vec3.h'"
check "an include does not climb" forbidden geometry/line.h '#include "geometry/../scene/rgb.h"' \
    "tree/geometry/line.h:2: room 'geometry' may not include 'geometry/../scene/rgb.h'"
check "an unknown room cannot be included" forbidden cli/command.h '#include "util/text.h"' \
    "tree/cli/command.h:2: room 'cli' may not include 'util/text.h'"
check "there is no room for odds and ends" forbidden util/text.h '' "tree/util/text.h:1: unknown room 'util'"
check "only main.cpp lies outside the rooms" forbidden text.cpp '' "tree/text.cpp:1: unknown room 'text.cpp'"
finish
