#pragma once

#include "scene/text/text_lines.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Comments, such as "command: multipath solve room.obj", which record a file's provenance, as its first lines: a `# `
/// line for each.
std::string comment_lines(const std::vector<std::string>& comments);

/// Value of the comment "name: value"; the first one if there are several.
std::optional<std::string> comment_value(const std::vector<std::string>& comments, std::string_view name);

/// Appends a number with 17 significant digits, which read back as the same double; never "-0".
void append_number(std::string& row, double value);

/// The text as a field of a row: quoted where it holds commas, quotes or line ends.
std::string csv_field(const std::string& text);

struct CsvRow
{
    std::vector<std::string> fields; ///< without the quotes
    std::uint32_t line = 0;          ///< of the file, from 1; the first one if a quoted field goes over several
};

/// A table as text: comments, the names of the columns, and rows that are all as long as the header.
struct CsvTable
{
    std::string path;                  ///< what messages call the table
    std::vector<std::string> comments; ///< without "# "
    CsvRow header;
    std::vector<CsvRow> rows;

    std::optional<std::size_t> find_column(std::string_view name) const;

    /// Throws InputError when there is none of that name.
    std::size_t column(std::string_view name) const;

    /// The field as a finite number, correctly rounded, whatever the locale. Throws InputError for any other text.
    double number(const CsvRow& row, std::size_t column) const;

    TextPlace place(const CsvRow& row) const { return {path, row.line}; }
};

/// Reads CSV strictly as RFC 4180 has it: fields quoted whole or not at all, lines that end in LF or CRLF; and besides,
/// lines with `#` before the header, which are comments. Throws InputError for anything else, for control characters
/// outside of what the project takes for text, and for two columns of one name. `path` is for messages.
CsvTable parse_csv(std::string_view text, const std::string& path);

/// The same from a file; throws InputError also for a file that TextLines refuses.
CsvTable read_csv(const std::string& path);

} // namespace multipath
