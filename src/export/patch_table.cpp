#include "export/patch_table.h"

#include "export/comments.h"
#include "export/csv_text.h"

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

} // namespace

std::string patch_table(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& standard_error,
                        const std::vector<std::string>& comments)
{
    std::string table = comment_lines(comments);
    table += std::string(header) + (standard_error.empty() ? "\n" : ",error_r,error_g,error_b\n");
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Patch patch = scene.patch(i);
        table += std::to_string(i) + "," + std::to_string(patch.surface) + "," + csv_field(scene.material_of(i).name);
        append(table, patch.shape.centre());
        append(table, patch.shape.normal());
        append(table, scene.area(i));
        append(table, scene.reflectance(i));
        append(table, scene.emittance(i));
        append(table, radiosity[i]);
        if (!standard_error.empty())
            append(table, standard_error[i]);
        table += "\n";
    }
    return table;
}

} // namespace multipath
