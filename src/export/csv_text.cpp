#include "export/csv_text.h"

#include "base/text_format.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace multipath {

namespace {

/// The fields of a line.
CsvRow row_of(std::string_view text, TextLocation place)
{
    CsvRow row{{}, place.line};
    for (std::size_t next = 0;; ++next) {
        std::string field;
        if (text.substr(next, 1) == "\"") {
            do {
                const std::size_t end = text.find('"', next + 1);
                if (end == std::string_view::npos)
                    refuse(place, "quote without end, expected a closing quote before the end of the line");
                field += text.substr(next + 1, end - next - 1);
                next = end + 1;
                if (text.substr(next, 1) == "\"") // doubled
                    field += '"';
            } while (text.substr(next, 1) == "\"");
            if (next < text.size() && text[next] != ',')
                refuse(place, "text after a closing quote, expected a comma or the end of the line");
        } else {
            field = text.substr(next, text.find(',', next) - next);
            if (field.find('"') != std::string::npos)
                refuse(place, "quote inside a field, expected the whole field in quotes and this one doubled");
            next += field.size();
        }
        row.fields.push_back(std::move(field));
        if (next == text.size())
            return row;
    }
}

CsvRow header_of(std::string_view text, TextLocation place)
{
    if (text.empty())
        refuse(place, "empty line, expected the names of the columns");
    CsvRow names = row_of(text, place);
    std::vector<std::string> sorted = names.fields;
    std::sort(sorted.begin(), sorted.end());
    const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
    if (twin != sorted.end())
        refuse(place, "two columns are named " + in_quotes(*twin) + ", expected different names");
    return names;
}

} // namespace

std::string comment_lines(const std::vector<std::string>& comments)
{
    std::string lines;
    for (const std::string& comment : comments)
        lines += "# " + comment + "\n";
    return lines;
}

std::optional<std::string> comment_value(const std::vector<std::string>& comments, std::string_view name)
{
    const std::string start = std::string(name) + ": ";
    for (const std::string& comment : comments)
        if (comment.compare(0, start.size(), start) == 0)
            return comment.substr(start.size());
    return std::nullopt;
}

void append_number(std::string& row, double value)
{
    std::array<char, 32> text = {value == 0.0 ? '0' : '1'};
    if (value != 0.0 && value != 1.0) // half of a table needs no conversion
        std::snprintf(text.data(), text.size(), "%.17g", value);
    row += text.data();
}

std::string csv_field(const std::string& text)
{
    if (text.find_first_of(",\"") == std::string::npos)
        return text;
    std::string field = "\"";
    for (const char c : text)
        field.append(c == '"' ? 2 : 1, c);
    return field + "\"";
}

std::optional<std::size_t> CsvTable::find_column(std::string_view name) const
{
    const auto found = std::find(header.fields.begin(), header.fields.end(), name);
    if (found == header.fields.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - header.fields.begin());
}

std::size_t CsvTable::column(std::string_view name) const
{
    const std::optional<std::size_t> found = find_column(name);
    if (!found)
        refuse(place(header), "no column " + in_quotes(name) + ", expected a column of that name");
    return *found;
}

double CsvTable::number(const CsvRow& row, std::size_t column) const
{
    return read_number(row.fields[column], place(row), header.fields[column]);
}

void CsvTable::refuse_field(const CsvRow& row, std::size_t column, const std::string& expected) const
{
    refuse(place(row), header.fields[column] + " is " + in_quotes(row.fields[column]) + ", expected " + expected);
}

CsvTable read_csv(const std::string& path)
{
    CsvTable table;
    table.path = path;
    TextLines lines(path, false);
    TextLine line;
    while (lines.next(line)) {
        const std::size_t columns = table.header.fields.size();
        if (columns == 0 && line.text.substr(0, 1) == "#") {
            table.comments.emplace_back(line.text.substr(line.text.substr(0, 2) == "# " ? 2 : 1));
        } else if (columns == 0) {
            table.header = header_of(line.text, line.place);
        } else {
            table.rows.push_back(row_of(line.text, line.place));
            if (table.rows.back().fields.size() != columns)
                refuse(line.place, "row has " + counted(table.rows.back().fields.size(), "field") + ", expected " +
                                       std::to_string(columns) + " as in the header");
        }
    }
    if (table.header.fields.empty())
        refuse({path, static_cast<std::uint32_t>(table.comments.size()) + 1},
               "the file ends here, expected a header with the names of the columns");
    return table;
}

} // namespace multipath
