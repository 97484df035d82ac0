#pragma once

#include "cli/options/command_line.h"
#include "radiosity/solve_options.h"
#include "scene/scene.h"
#include "scene/scene_file.h"

#include <string>

namespace multipath {

/// `--memory`: a definition for the tables.
Option memory_option();

// Work that is too large for the memory is refused with the numbers before anything is allocated; the system might
// allow the allocation and end the program later. The limit is --memory, else what the machine has. These throw
// InputError.

void require_memory_for_file(const CommandLine& line, const std::string& path);
void require_memory_for_patches(const CommandLine& line, const SceneFile& file, double patches);
void require_memory_for_page(const CommandLine& line, const Scene& scene);
void require_memory_for_reuse(const CommandLine& line, const SolveOptions& options, const Scene& scene);
void require_memory_for_picture(const CommandLine& line, int width, int height, bool gathers);

/// How many runs of the method `reuse` may go on at a time on a scene: one at least, `threads` at most.
int reuse_runs_at_a_time(const CommandLine& line, const Scene& scene, int threads);

} // namespace multipath
