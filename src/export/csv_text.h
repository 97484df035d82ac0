#pragma once

#include "scene/text/text_lines.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Formats comments, which record a file's provenance ("command: multipath solve room.obj"), as `# ` lines.
std::string comment_lines(const std::vector<std::string>& comments);

/// Value of the first comment "name: value"; nothing if there is none.
std::optional<std::string> comment_value(const std::vector<std::string>& comments, std::string_view name);

/// Appends a number with 17 significant digits, which are read back as the same double; -0.0 is written as 0.
void append_number(std::string& row, double value);

/// Formats text as a CSV field: in quotes if it contains commas or quotes.
std::string csv_field(const std::string& text);

struct CsvRow
{
    std::vector<std::string> fields; ///< without quotes
    std::uint32_t line = 0;          ///< line on which the row starts, counted from 1
};

/// A parsed CSV file. All rows have as many fields as the header.
struct CsvTable
{
    std::string path;                  ///< name of the table in messages
    std::vector<std::string> comments; ///< without "# "
    CsvRow header;
    std::vector<CsvRow> rows;

    /// Index of the column with this name; nothing if there is none.
    std::optional<std::size_t> find_column(std::string_view name) const;

    /// Index of the column with this name. Throws InputError if there is none.
    std::size_t column(std::string_view name) const;

    /// Parses a field as a finite number, correctly rounded and independent of the locale. Throws InputError if the
    /// field is not a finite number.
    double number(const CsvRow& row, std::size_t column) const;

    /// Throws InputError: "patch is `x`, expected ...".
    [[noreturn]] void refuse_field(const CsvRow& row, std::size_t column, const std::string& expected) const;

    TextLocation place(const CsvRow& row) const { return {path, row.line}; }
};

/// Reads a CSV file: RFC 4180, but without line ends in fields, and with comments, the lines before the header that
/// start with `#`. Fields are quoted entirely or not at all. Throws InputError for anything else, for two columns with
/// the same name, and where TextLines does.
CsvTable read_csv(const std::string& path);

} // namespace multipath
