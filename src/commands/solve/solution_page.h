#pragma once

#include "commands/explain/trace_text.h"
#include "commands/options/picture_options.h"
#include "radiosity/solve.h"
#include "viewer/viewer_page.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// The first hundred lines of every kind that the run casts, or fewer where it has not so many: rays of the first shot
/// and global lines, or particles. For the method `reuse`, which only counts its lines, those of the method `extended`.
std::vector<ViewerChapter> viewer_chapters(const TracedRun& run);

/// The numbers of lines of the stages below `lines`, rising: 2^8, 2^10 ... or wider steps, as long as one radiosity for
/// each stays a small part of a page. None for few lines or more than 300,000 patches.
std::vector<std::uint64_t> stage_lines(std::uint64_t lines, std::uint32_t patches);

/// The radiosity after so many lines, solved anew for each with the options of the run. Numbers of lines with which the
/// method cannot work, or finds no light, are left out.
std::vector<ViewerStage> solve_stages(const Scene& scene, const SolveOptions& options,
                                      const std::vector<std::uint64_t>& lines, const ProgressCallback& progress);

/// The page (.html) to walk through a solved room: the solution, what fewer lines would have given, for which it solves
/// again, and the first lines of the run. `comments` say where it comes from.
std::string solution_page(const TracedRun& run, const Solution& solution, const PictureOptions& picture_options,
                          const std::vector<std::string>& comments, const ProgressCallback& progress);

} // namespace multipath
