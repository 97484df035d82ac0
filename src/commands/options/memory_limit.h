#pragma once

#include "cli/options/command_line.h"
#include "radiosity/run/solve_options.h"
#include "scene/scene.h"
#include "scene/scene_file.h"

#include <string>

namespace multipath {

/// The option --memory for the tables of commands.
Option memory_option();

// The require_ functions throw InputError if the work needs more memory than --memory allows; the message states both
// sizes. Without --memory the limit is the memory of the machine, or of the container in which the program runs. The
// functions are called before anything is allocated: the system might grant the allocation and kill the program later.

/// Checks the memory for reading a file. A file of unknown size, such as a pipe, passes.
void require_memory_for_file(const CommandLine& line, const std::string& path);
/// Checks the memory for solving a scene with this number of patches, which may be infinite.
void require_memory_for_patches(const CommandLine& line, const SceneFile& file, double patches);
/// Checks the memory for the page (.html) of a scene.
void require_memory_for_page(const CommandLine& line, const Scene& scene);
/// Checks the memory for the method `reuse`. Other methods pass, and so do runs with too few lines for line reuse.
void require_memory_for_reuse(const CommandLine& line, const SolveOptions& options, const Scene& scene);
/// Checks the memory for a picture of width x height pixels. `gathers`: true for final gathering, which needs more.
void require_memory_for_picture(const CommandLine& line, int width, int height, bool gathers);

/// Number of runs of the method `reuse` on a scene that fit into the memory at the same time; at least 1 and at most
/// `threads`.
int reuse_runs_at_a_time(const CommandLine& line, const Scene& scene, int threads);

} // namespace multipath
