#pragma once

#include "geometry/vec3.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// A solution as CSV, one row per patch: surface, material, centre, normal, area, reflectance, emittance and radiosity
/// [W/m^2], with 17 significant digits, from which the same doubles are read back. If `standard_error` is not empty, it
/// fills three more columns. Patches of the sky have area 0. The comments become `# ` lines before the header.
std::string patch_table(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& standard_error,
                        const std::vector<std::string>& comments, int threads = 1);

/// A solution read from a file of patch_table(). The lists have one entry per patch.
struct PatchTable
{
    std::string path;
    std::vector<std::string> comments; ///< without "# "; comment_value() searches them
    std::vector<std::uint32_t> surfaces;
    std::vector<std::string> materials; ///< names
    std::vector<Vec3> centres;          ///< [m]
    std::vector<double> areas;          ///< [m^2] not negative, 0 for the sky; not all are 0
    std::vector<Rgb> radiosity;         ///< [W/m^2]
    std::vector<Rgb> standard_error;    ///< [W/m^2] of the radiosity, not negative; empty if the table has none
};

/// Reads a table; columns are found by name, and columns with other names are ignored. Throws InputError for a file
/// that is no such table, whose patches are not numbered 0, 1, 2 ..., or whose areas are all 0. A table without areas,
/// for example by another program, needs only the columns `patch` and `radiosity` [W/m^2], or `radiosity_r`, `_g`,
/// `_b`. All else is then copied from `beside`, which must have as many patches.
PatchTable read_patch_table(const std::string& path, const PatchTable* beside = nullptr);

} // namespace multipath
