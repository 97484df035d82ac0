#pragma once

#include "cli/options/command_line.h"
#include "radiosity/solve_options.h"
#include "scene/scene.h"
#include "scene/scene_file.h"

#include <string>

namespace multipath {

/// The option --memory for the tables of commands.
Option memory_option();

// These functions throw InputError, with the numbers, if the work needs more memory than --memory or, without it, than
// the machine has. They are called before anything is allocated: the system might grant the allocation and kill the
// program later.

void require_memory_for_file(const CommandLine& line, const std::string& path);
void require_memory_for_patches(const CommandLine& line, const SceneFile& file, double patches);
void require_memory_for_page(const CommandLine& line, const Scene& scene);
void require_memory_for_reuse(const CommandLine& line, const SolveOptions& options, const Scene& scene);
void require_memory_for_picture(const CommandLine& line, int width, int height, bool gathers);

/// Number of runs of the method `reuse` on a scene that fit into the memory at the same time, 1 to `threads`.
int reuse_runs_at_a_time(const CommandLine& line, const Scene& scene, int threads);

} // namespace multipath
