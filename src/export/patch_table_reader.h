#pragma once

#include "geometry/vec3.h"
#include "scene/rgb.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

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
PatchTable read_patch_table(const std::string& path);

} // namespace multipath
