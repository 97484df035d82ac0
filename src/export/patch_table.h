#pragma once

#include "geometry/vec3.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// The result as CSV, one row per patch: place, area, material and radiosity [W/m^2], numbers with 17 significant
/// digits, so that reading them gives the same doubles. Standard errors, if there are any, are three columns more. The
/// comments become `# ` lines before the header.
std::string patch_table(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& standard_error,
                        const std::vector<std::string>& comments, int threads = 1);

/// A result as patch_table() wrote it. The lists have one entry per patch.
struct PatchTable
{
    std::string path;
    std::vector<std::string> comments; ///< without "# "; comment_value() finds what one of them says
    std::vector<std::uint32_t> surfaces;
    std::vector<std::string> materials; ///< names
    std::vector<Vec3> centres;          ///< [m]
    std::vector<double> areas;          ///< [m^2] above 0
    std::vector<Rgb> radiosity;         ///< [W/m^2]
    std::vector<Rgb> standard_error;    ///< [W/m^2] of the radiosity, not negative; empty if the table has none
};

/// Reads the columns by their names, the numbers to the same doubles that were written; columns of other names are
/// ignored. Throws InputError for a file that is no such table, or whose patches are not counted 0, 1, 2 ...
/// A table without areas, as another program may have written it, needs only `patch` and `radiosity` [W/m^2], or the
/// three channels of it; if it is `beside` another one of as many patches, the rest is taken from there.
PatchTable read_patch_table(const std::string& path, const PatchTable* beside = nullptr);

} // namespace multipath
