#pragma once

#include "commands/options/picture_options.h"
#include "explain/stage_trace.h"
#include "radiosity/run/solution.h"
#include "radiosity/run/solve_options.h"

#include <string>
#include <vector>

namespace multipath {

/// One chapter for each stage of the run that can be traced, with the traces of its first 100 lines, or of 10 or 1 if
/// the stage has fewer. The traces are those of a run with the same options, but at most 2^16 lines in total. A method
/// that only counts its lines, such as `reuse`, is represented by another (MethodInfo::traced_as).
std::vector<StageTrace> viewer_chapters(const Scene& scene, const SolveOptions& options);

/// The page (.html) to walk through a solved room. It shows the solution and traces of lines (viewer_chapters).
/// `comments`: provenance of the page.
std::string solution_page(const Scene& scene, const SolveOptions& options, const Solution& solution,
                          const PictureOptions& picture_options, const std::vector<std::string>& comments);

} // namespace multipath
