#include "export/patch_table.h"

#include "export/csv_text.h"
#include "parallel/blocks.h"

#include <array>
#include <charconv>
#include <optional>
#include <system_error>

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

[[noreturn]] void refuse_field(const CsvTable& table, const CsvRow& row, std::size_t column,
                               const std::string& expected)
{
    refuse(table.place(row),
           table.header.fields[column] + " is " + in_quotes(row.fields[column]) + ", expected " + expected);
}

void require_patch(const CsvTable& table, const CsvRow& row, std::size_t column, std::size_t patch)
{
    if (row.fields[column] != std::to_string(patch))
        refuse_field(table, row, column, std::to_string(patch) + ", since patches are numbered from 0");
}

std::uint32_t read_surface(const CsvTable& table, const CsvRow& row, std::size_t column)
{
    const std::string& text = row.fields[column];
    const char* const end = text.data() + text.size();
    std::uint32_t surface = 0;
    const std::from_chars_result result = std::from_chars(text.data(), end, surface);
    if (result.ec != std::errc() || result.ptr != end)
        refuse_field(table, row, column, "the number of a surface");
    return surface;
}

double read_not_negative(const CsvTable& table, const CsvRow& row, std::size_t column)
{
    const double number = table.number(row, column);
    if (!(number >= 0.0))
        refuse_field(table, row, column, "0 or more");
    return number;
}

/// Reads a Vec3 or an Rgb.
template <class Three>
Three read_three(const CsvTable& table, const CsvRow& row, const ThreeColumns& columns)
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

/// Reads all columns but the patch, the radiosity and its standard error.
void read_geometry(const CsvTable& table, PatchTable& patches)
{
    const std::size_t surface = table.column("surface");
    const std::size_t material = table.column("material");
    const ThreeColumns centre = columns_named(table, {"x", "y", "z"});
    const std::size_t area = table.column("area");
    double whole_area = 0.0;
    for (const CsvRow& row : table.rows) {
        patches.surfaces.push_back(read_surface(table, row, surface));
        patches.materials.push_back(row.fields[material]);
        patches.centres.push_back(read_three<Vec3>(table, row, centre));
        patches.areas.push_back(read_not_negative(table, row, area));
        whole_area += patches.areas.back();
    }
    if (!(whole_area > 0.0))
        refuse(table.place(table.header), "all areas are 0, expected a patch with an area");
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
    PatchTable patches = bare ? *beside : PatchTable{};
    patches.path = path;
    patches.comments = table.comments;
    patches.radiosity.clear();
    patches.standard_error.clear();
    for (const CsvRow& row : table.rows) {
        require_patch(table, row, patch, patches.radiosity.size());
        patches.radiosity.push_back(read_three<Rgb>(table, row, radiosity));
        if (error) {
            for (const std::size_t column : *error)
                read_not_negative(table, row, column);
            patches.standard_error.push_back(read_three<Rgb>(table, row, *error));
        }
    }
    if (!bare)
        read_geometry(table, patches);
    else if (patches.radiosity.size() != beside->areas.size())
        refuse(table.place(table.header), std::to_string(patches.radiosity.size()) + " patches, expected " +
                                              std::to_string(beside->areas.size()) + " as in " + beside->path);
    return patches;
}

} // namespace multipath
