#pragma once

#include "commands/explain/trace_text.h"
#include "commands/options/picture_options.h"
#include "radiosity/solve.h"
#include "viewer/viewer_page.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Traces of the first lines of every stage of the run that can be traced, one chapter per stage: 100 lines, or 10 or 1
/// if the stage has fewer. The traced run has at most 2^16 lines in total. A method that only counts its lines, such as
/// `reuse`, is represented by another (MethodInfo::traced_as).
std::vector<ViewerChapter> viewer_chapters(const TracedRun& run);

/// Numbers of lines for the stages of a page, increasing and below `lines`: 2^8, 2^10 ... or in wider steps. There are
/// at most 20 stages, with at most 300,000 values in total, so that they remain a small part of the page. Empty if
/// `lines` is at most 2^8, or for more than 300,000 patches.
std::vector<std::uint64_t> stage_lines(std::uint64_t lines, std::uint32_t patches);

/// The radiosity after each of these numbers of lines, solved anew with the options of the run. A number is left out if
/// the method cannot work with so few lines or finds no light. `progress` is called with the share of the work that is
/// done.
std::vector<ViewerStage> solve_stages(const Scene& scene, const SolveOptions& options,
                                      const std::vector<std::uint64_t>& lines, const ProgressCallback& progress);

/// The page (.html) to walk through a solved room. It shows the solution, the radiosity with fewer lines
/// (solve_stages), and traces of lines (viewer_chapters). `comments`: provenance of the page.
std::string solution_page(const TracedRun& run, const Solution& solution, const PictureOptions& picture_options,
                          const std::vector<std::string>& comments, const ProgressCallback& progress);

} // namespace multipath
