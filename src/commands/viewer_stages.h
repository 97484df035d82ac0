#pragma once

#include "radiosity/solve.h"
#include "viewer/viewer_content.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The numbers of lines of the stages below `lines`, rising: 2^8, 2^10 ... or wider steps, as long as one radiosity for
/// each stays a small part of a page. None for few lines or more than 300,000 patches.
std::vector<std::uint64_t> stage_lines(std::uint64_t lines, std::uint32_t patches);

/// The radiosity after so many lines, solved anew for each with the options of the run. Numbers of lines with which the
/// method cannot work, or finds no light, are left out.
std::vector<ViewerStage> solve_stages(const Scene& scene, const SolveOptions& options,
                                      const std::vector<std::uint64_t>& lines, const ProgressCallback& progress);

} // namespace multipath
