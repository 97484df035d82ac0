#include "commands/solve/solve_table.h"

#include "commands/options/method_options.h"
#include "commands/options/picture_options.h"
#include "commands/options/scene_options.h"
#include "commands/solve/accuracy.h"
#include "commands/solve/formats.h"
#include "commands/solve/saved_run.h"

namespace multipath {

CommandTable solve_table()
{
    return {"solve",
            "compute the radiosity of a scene, and write pictures, meshes and tables",
            {{"SCENE.obj", false, false, {".obj"}}},
            {solution_output_group(), solve_method_group(), accuracy_option_group(), state_option_group(),
             scene_option_group(), picture_option_group()},
            "Numbers may be written 1000000, 1e6, 1M or 2^20.\n"
            "\n"
            "  multipath solve room.obj\n"
            "  multipath solve room.obj --lines 2^22 --sequence halton:2,7,3,5 -o room.png -o room.csv\n"
            "  multipath solve room.obj -o room.glb -o room.ply\n"
            "  multipath solve room.obj -o room.html\n"};
}

} // namespace multipath
