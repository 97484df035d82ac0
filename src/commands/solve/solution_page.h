#pragma once

#include "commands/explain/trace_text.h"
#include "commands/options/picture_options.h"
#include "radiosity/run/solve.h"
#include "viewer/viewer_page.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// One chapter for each stage of the run that can be traced, with the traces of its first 100 lines, or of 10 or 1 if
/// the stage has fewer. The traces are those of a run with the same options, but at most 2^16 lines in total. A method
/// that only counts its lines, such as `reuse`, is represented by another (MethodInfo::traced_as).
std::vector<ViewerChapter> viewer_chapters(const TracedRun& run);

/// Numbers of lines for the stages of a page, which are solutions with fewer lines than the run: 2^8, 2^10 ... or in
/// wider steps, increasing and below `lines`. There are at most 20 stages, with at most 300,000 values in total, so
/// that they remain a small part of the page. Empty if `lines` is at most 2^8, or for more than 300,000 patches.
std::vector<std::uint64_t> stage_lines(std::uint64_t lines, std::uint32_t patches);

/// The radiosity with each of these numbers of lines: each is solved by a run of its own with these options. A number
/// is left out if the method cannot work with so few lines, or if no surface absorbs light in the solution. `progress`
/// is called with the share of the work that is done.
std::vector<ViewerStage> solve_stages(const Scene& scene, const SolveOptions& options,
                                      const std::vector<std::uint64_t>& lines, const ProgressCallback& progress);

/// The page (.html) to walk through a solved room. It shows the solution, the radiosity with fewer lines
/// (solve_stages), and traces of lines (viewer_chapters). `comments`: provenance of the page.
std::string solution_page(const TracedRun& run, const Solution& solution, const PictureOptions& picture_options,
                          const std::vector<std::string>& comments, const ProgressCallback& progress);

} // namespace multipath
