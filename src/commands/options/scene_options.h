#pragma once

#include "base/errors.h"
#include "cli/options/command_line.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// The options of every command that reads an OBJ scene.
OptionGroup scene_option_group();

/// The option that applies a remedy, after a space and quoted for a shell: " --lamp 'desk lamp=10'".
std::string option_text(const Advice& advice);

/// Clauses to end a message: "; --flip turns all faces over; --two-sided gives every face a back", or only options
/// where the message states their effect: ": --sky 10 --sun 150,40,20".
std::string advice_text(const std::vector<Advice>& list);

/// Path of the scene file that the first operand names: the file itself if it exists; for a name without folder, with
/// or without `.obj`, otherwise the bundled scene of that name. If there is none, the operand unchanged, so that the
/// message of the reader quotes it.
std::string scene_path(const CommandLine& line);

/// Reads the scene of the first operand and cuts it into patches as the options say. If patches are adaptive, these are
/// the coarse patches from which refinement begins. Throws UsageError, and InputError for a faulty file or too little
/// memory.
Scene read_scene(const CommandLine& line, int threads = 1);

/// Number of adaptive patches that --adaptive asks for, or that `solve` chooses without --adaptive, --patches and
/// --patch-size. 0 if patches are not adaptive: for other commands, and without --adaptive if --patches or --patch-size
/// is given or the scene has more than a million surfaces. Throws UsageError.
std::uint64_t adaptive_patches(const CommandLine& line, const SurfaceList& surfaces);

/// The option --threads for the tables of commands.
Option threads_option();

/// The value of --threads; all processors by default. Throws UsageError.
int thread_count(const CommandLine& line);

/// The folder of the scenes that come with the program: PREFIX/share/multipath/scenes for an installed program, or the
/// folder `scenes` beside a program that was built from sources. Empty if there is neither, or if the path of the
/// program is unknown.
std::string bundled_scenes_folder();

} // namespace multipath
