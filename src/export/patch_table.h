#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// The result as CSV, one row per patch: place, area, material and radiosity [W/m^2], numbers with 17 significant
/// digits, so that reading them gives the same doubles. Standard errors, if there are any, are three columns more. The
/// comments become `# ` lines before the header.
std::string patch_table(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& standard_error,
                        const std::vector<std::string>& comments, int threads = 1);

} // namespace multipath
