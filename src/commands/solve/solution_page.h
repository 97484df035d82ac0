#pragma once

#include "commands/explain/trace_text.h"
#include "commands/options/picture_options.h"
#include "radiosity/solve.h"
#include "viewer/viewer_page.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Traces of the first hundred lines, or fewer, of every kind that the run casts: rays of the first shot and global
/// lines, or particles. A method that only counts its lines, such as `reuse`, is represented by another
/// (MethodInfo::traced_as).
std::vector<ViewerChapter> viewer_chapters(const TracedRun& run);

/// Numbers of lines of the stages, increasing and below `lines`: 2^8, 2^10 ... or in wider steps, so that the
/// radiosities of all stages remain a small part of a page. Empty for at most 2^8 lines or more than 300,000 patches.
std::vector<std::uint64_t> stage_lines(std::uint64_t lines, std::uint32_t patches);

/// The radiosity after each of these numbers of lines, solved anew with the options of the run. Numbers of lines with
/// which the method cannot work, or finds no light, are left out.
std::vector<ViewerStage> solve_stages(const Scene& scene, const SolveOptions& options,
                                      const std::vector<std::uint64_t>& lines, const ProgressCallback& progress);

/// The page (.html) to walk through a solved room: the solution, the radiosity with fewer lines, for which it solves
/// again, and traces of the first lines of the run. `comments` is the provenance.
std::string solution_page(const TracedRun& run, const Solution& solution, const PictureOptions& picture_options,
                          const std::vector<std::string>& comments, const ProgressCallback& progress);

} // namespace multipath
