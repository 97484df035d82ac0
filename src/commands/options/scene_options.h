#pragma once

#include "cli/options/command_line.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// The options of every command that reads an OBJ scene.
OptionGroup scene_option_group();

/// The file of the scene that the first operand names: as given, or the bundled one of that name.
std::string scene_path(const CommandLine& line);

/// The given options that change how the file is read, not what is done with it: --flip without a value, --unit, ...
struct GivenOption
{
    std::string name;
    std::string value; ///< empty: takes none
};
std::vector<GivenOption> reading_options(const CommandLine& line);

/// That scene, cut into patches as the options say, of adaptive ones into those that they begin with. Throws
/// UsageError, InputError.
Scene read_scene(const CommandLine& line, int threads = 1);

/// How many adaptive patches the options ask for; without --patches and --patch-size `solve` chooses for itself. 0 for
/// those that are read. Throws UsageError.
std::uint64_t adaptive_patches(const CommandLine& line, const SurfaceList& surfaces);

/// `--threads`: a definition for the tables, and its value; without it, all processors.
Option threads_option();
int thread_count(const CommandLine& line);

/// The folder of the scenes that come with the program: of an installed one PREFIX/share/multipath/scenes, of one that
/// was built beside its sources their folder `scenes`. Empty when there is none or the program cannot tell where it is.
std::string bundled_scenes_folder();

} // namespace multipath
