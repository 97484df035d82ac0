#include "export/patch_table_reader.h"

#include "export/csv_text.h"

#include <array>
#include <charconv>
#include <optional>
#include <system_error>

namespace multipath {

namespace {

using ThreeColumns = std::array<std::size_t, 3>;

struct Columns
{
    explicit Columns(const CsvTable& table);

    std::size_t patch;
    std::size_t surface;
    std::size_t material;
    ThreeColumns centre;
    std::size_t area;
    ThreeColumns radiosity;
    std::optional<ThreeColumns> error;
};

ThreeColumns columns_named(const CsvTable& table, const std::array<const char*, 3>& names)
{
    return {table.column(names[0]), table.column(names[1]), table.column(names[2])};
}

Columns::Columns(const CsvTable& table)
    : patch(table.column("patch")),
      surface(table.column("surface")),
      material(table.column("material")),
      centre(columns_named(table, {"x", "y", "z"})),
      area(table.column("area")),
      radiosity(columns_named(table, {"radiosity_r", "radiosity_g", "radiosity_b"}))
{
    const std::array<const char*, 3> names = {"error_r", "error_g", "error_b"};
    for (const char* name : names)
        if (table.find_column(name))
            error = columns_named(table, names);
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
        refuse_field(table, row, column, std::to_string(patch) + ", since patches count from 0");
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

double read_area(const CsvTable& table, const CsvRow& row, std::size_t column)
{
    const double area = table.number(row, column);
    if (!(area > 0.0))
        refuse_field(table, row, column, "more than 0");
    return area;
}

Vec3 read_point(const CsvTable& table, const CsvRow& row, const ThreeColumns& columns)
{
    return {table.number(row, columns[0]), table.number(row, columns[1]), table.number(row, columns[2])};
}

Rgb read_rgb(const CsvTable& table, const CsvRow& row, const ThreeColumns& columns)
{
    return {table.number(row, columns[0]), table.number(row, columns[1]), table.number(row, columns[2])};
}

Rgb read_error(const CsvTable& table, const CsvRow& row, const ThreeColumns& columns)
{
    for (const std::size_t column : columns)
        if (table.number(row, column) < 0.0)
            refuse_field(table, row, column, "0 or more");
    return read_rgb(table, row, columns);
}

} // namespace

PatchTable read_patch_table(const std::string& path)
{
    const CsvTable table = read_csv(path);
    const Columns columns(table);
    if (table.rows.empty())
        refuse(table.place(table.header), "no row behind the header, expected one per patch");
    PatchTable patches;
    patches.path = path;
    patches.comments = table.comments;
    for (const CsvRow& row : table.rows) {
        require_patch(table, row, columns.patch, patches.areas.size());
        patches.surfaces.push_back(read_surface(table, row, columns.surface));
        patches.materials.push_back(row.fields[columns.material]);
        patches.centres.push_back(read_point(table, row, columns.centre));
        patches.areas.push_back(read_area(table, row, columns.area));
        patches.radiosity.push_back(read_rgb(table, row, columns.radiosity));
        if (columns.error)
            patches.standard_error.push_back(read_error(table, row, *columns.error));
    }
    return patches;
}

} // namespace multipath
