#include "export/patch_table.h"

#include "export/comments.h"
#include "export/csv_text.h"
#include "parallel/ordered_blocks.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace multipath {

namespace {

constexpr const char* header = "patch,surface,material,x,y,z,nx,ny,nz,area,reflectance_r,reflectance_g,reflectance_b,"
                               "emittance_r,emittance_g,emittance_b,radiosity_r,radiosity_g,radiosity_b";

void append(std::string& row, double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), ",%.17g", value == 0.0 ? 0.0 : value); // never "-0"
    row += text.data();
}

void append(std::string& row, Vec3 v)
{
    append(row, v.x);
    append(row, v.y);
    append(row, v.z);
}

void append(std::string& row, Rgb c)
{
    append(row, c.r);
    append(row, c.g);
    append(row, c.b);
}

/// The rows of the patches first ... end - 1.
std::string rows(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& standard_error,
                 std::uint32_t first, std::uint32_t end)
{
    std::string table;
    std::string material; // these three of the side to which the last patch belongs
    std::string constants;
    std::uint32_t next_side = first;
    for (std::uint32_t i = first; i < end; ++i) {
        const Patch patch = scene.patch(i);
        if (i == next_side) {
            const bool front = scene.is_front(i);
            next_side = scene.first_patch(patch.surface, front) +
                        static_cast<std::uint32_t>(scene.tessellation(patch.surface).cell_count());
            material = csv_field(scene.material_of(i).name);
            constants.clear();
            append(constants, patch.shape.normal());
            append(constants, scene.area(i));
            append(constants, scene.reflectance(i));
            append(constants, scene.emittance(i));
        }
        table += std::to_string(i) + "," + std::to_string(patch.surface) + "," + material;
        append(table, patch.shape.centre());
        table += constants;
        append(table, radiosity[i]);
        if (!standard_error.empty())
            append(table, standard_error[i]);
        table += "\n";
    }
    return table;
}

} // namespace

std::string patch_table(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& standard_error,
                        const std::vector<std::string>& comments, int threads)
{
    constexpr std::uint64_t patches_at_a_time = 4096;
    std::string table = comment_lines(comments);
    table += std::string(header) + (standard_error.empty() ? "\n" : ",error_r,error_g,error_b\n");
    std::vector<std::string> parts(static_cast<std::size_t>(slot_count(threads)));
    const std::uint64_t count = scene.patch_count();
    ordered_blocks((count + patches_at_a_time - 1) / patches_at_a_time, threads,
                   [&](std::uint64_t block, int slot) {
                       const std::uint64_t first = block * patches_at_a_time;
                       parts[static_cast<std::size_t>(slot)] =
                           rows(scene, radiosity, standard_error, static_cast<std::uint32_t>(first),
                                static_cast<std::uint32_t>(std::min(count, first + patches_at_a_time)));
                   },
                   [&](std::uint64_t, int slot) { table += parts[static_cast<std::size_t>(slot)]; });
    return table;
}

} // namespace multipath
