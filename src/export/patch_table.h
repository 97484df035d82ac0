#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// A solution as CSV, one row per patch: index of the patch, index of its surface, material, centre, normal, area,
/// reflectance, emittance and radiosity [W/m^2]. Numbers have 17 significant digits, from which the same doubles are
/// read back. `standard_error` [W/m^2] fills three more columns unless it is empty. Patches of the sky have area 0. The
/// comments become `# ` lines before the header.
std::string patch_table(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& standard_error,
                        const std::vector<std::string>& comments, int threads = 1);

/// A solution read from a file of patch_table(). The lists have one entry per patch.
struct PatchTable
{
    std::string path;                  ///< name of the file in messages
    std::vector<std::string> comments; ///< without "# "; comment_value() searches them
    std::vector<double> areas;         ///< [m^2] 0 for patches of the sky; at least one is positive, none negative
    std::vector<Rgb> radiosity;        ///< [W/m^2]
    std::vector<Rgb> standard_error;   ///< [W/m^2] not negative; empty if the table has none
};

/// Reads a table; columns are found by name, and columns with other names are ignored. Throws InputError for a file
/// that is no such table, and for one without rows, with patches that are not numbered 0, 1, 2 ..., with negative areas
/// or standard errors, or with areas that are all 0.
/// If `beside` is given, a table without areas, for example by another program, needs only the columns `patch` and
/// `radiosity` [W/m^2], or `radiosity_r`, `_g`, `_b`; the columns of the standard error are optional. The areas are
/// copied from `beside`, and InputError is thrown unless both tables have the same number of patches. A table with
/// areas is read as if `beside` were not given.
PatchTable read_patch_table(const std::string& path, const PatchTable* beside = nullptr);

} // namespace multipath
