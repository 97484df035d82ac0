#include "export/patch_table.h"

#include "export/csv_text.h"
#include "parallel/blocks.h"

#include <array>
#include <numeric>
#include <optional>

namespace multipath {

namespace {

constexpr const char* header = "patch,surface,material,x,y,z,nx,ny,nz,area,reflectance_r,reflectance_g,reflectance_b,"
                               "emittance_r,emittance_g,emittance_b,radiosity_r,radiosity_g,radiosity_b";

void append(std::string& row, double value)
{
    row += ',';
    append_number(row, value);
}

void append(std::string& row, Vec3 v)
{
    for (const double x : {v.x, v.y, v.z})
        append(row, x);
}

void append(std::string& row, Rgb c)
{
    append(row, Vec3{c.r, c.g, c.b});
}

/// The rows of the patches first ... end - 1.
std::string rows(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& standard_error,
                 std::uint32_t first, std::uint32_t end)
{
    std::string table;
    for (std::uint32_t i = first; i < end; ++i) {
        const Patch patch = scene.patch(i);
        table += std::to_string(i) + "," + std::to_string(patch.surface) + "," + csv_field(scene.material_of(i).name);
        append(table, patch.shape.centre());
        append(table, patch.shape.normal());
        append(table, scene.is_sky(patch.surface) ? 0.0 : scene.area(i));
        for (const Rgb colour : {scene.reflectance(i), scene.emittance(i), radiosity[i]})
            append(table, colour);
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
    BlockBuffers<std::string> parts(threads);
    const Blocks blocks = {scene.patch_count(), patches_at_a_time};
    ordered_blocks(
        blocks.count(), threads,
        [&](std::uint64_t block, int slot) {
            parts[slot] = rows(scene, radiosity, standard_error, static_cast<std::uint32_t>(blocks.first(block)),
                               static_cast<std::uint32_t>(blocks.first(block + 1)));
        },
        [&](std::uint64_t, int slot) { table += parts[slot]; });
    return table;
}

namespace {

using ThreeColumns = std::array<std::size_t, 3>;

ThreeColumns columns_named(const CsvTable& table, const std::array<const char*, 3>& names)
{
    return {table.column(names[0]), table.column(names[1]), table.column(names[2])};
}

/// The columns of the standard error, or nothing if the table has none. If it has one of them, all are required.
std::optional<ThreeColumns> error_columns(const CsvTable& table)
{
    const std::array<const char*, 3> names = {"error_r", "error_g", "error_b"};
    for (const char* name : names)
        if (table.find_column(name))
            return columns_named(table, names);
    return std::nullopt;
}

double read_not_negative(const CsvTable& table, const CsvRow& row, std::size_t column)
{
    const double number = table.number(row, column);
    if (!(number >= 0.0))
        table.refuse_field(row, column, "0 or more");
    return number;
}

Rgb read_colour(const CsvTable& table, const CsvRow& row, const ThreeColumns& columns)
{
    return {table.number(row, columns[0]), table.number(row, columns[1]), table.number(row, columns[2])};
}

/// The columns of the radiosity: one per channel, or `radiosity` for all of them if `grey` is true and there is one.
ThreeColumns radiosity_columns(const CsvTable& table, bool grey)
{
    if (const std::optional<std::size_t> all = table.find_column("radiosity"); grey && all)
        return {*all, *all, *all};
    return columns_named(table, {"radiosity_r", "radiosity_g", "radiosity_b"});
}

std::vector<double> read_areas(const CsvTable& table)
{
    const std::size_t column = table.column("area");
    std::vector<double> areas;
    for (const CsvRow& row : table.rows)
        areas.push_back(read_not_negative(table, row, column));
    if (!(std::accumulate(areas.begin(), areas.end(), 0.0) > 0.0))
        refuse(table.place(table.header), "all areas are 0, expected a patch with an area");
    return areas;
}

} // namespace

PatchTable read_patch_table(const std::string& path, const PatchTable* beside)
{
    const CsvTable table = read_csv(path);
    const bool bare = beside && !table.find_column("area");
    const std::size_t patch = table.column("patch");
    const ThreeColumns radiosity = radiosity_columns(table, bare);
    const std::optional<ThreeColumns> error = error_columns(table);
    if (table.rows.empty())
        refuse(table.place(table.header), "no rows after the header, expected one per patch");
    PatchTable patches;
    patches.path = path;
    patches.comments = table.comments;
    for (const CsvRow& row : table.rows) {
        const std::string number = std::to_string(patches.radiosity.size());
        if (row.fields[patch] != number)
            table.refuse_field(row, patch, number + ", since patches are numbered from 0");
        patches.radiosity.push_back(read_colour(table, row, radiosity));
        if (error) {
            for (const std::size_t column : *error)
                read_not_negative(table, row, column);
            patches.standard_error.push_back(read_colour(table, row, *error));
        }
    }
    patches.areas = bare ? beside->areas : read_areas(table);
    if (patches.radiosity.size() != patches.areas.size())
        refuse(table.place(table.header), std::to_string(patches.radiosity.size()) + " patches, expected " +
                                              std::to_string(beside->areas.size()) + " as in " + beside->path);
    return patches;
}

} // namespace multipath
