#include "export/csv_text.h"

#include "base/text_format.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace multipath {

namespace {

bool is_empty_line(const CsvRow& row)
{
    return row.fields.size() == 1 && row.fields[0].empty();
}

/// Recursive-descent parser with one function per element of the grammar. `next_` is the position in the text.
class CsvParser
{
public:
    CsvParser(std::string_view text, const std::string& path) : text_(text), path_(path) {}

    CsvTable parse()
    {
        CsvTable table;
        table.path = path_;
        while (at('#'))
            table.comments.push_back(comment());
        table.header = header();
        const std::size_t columns = table.header.fields.size();
        while (!ended()) {
            CsvRow next = row(columns);
            if (next.fields.size() != columns)
                refuse(table.place(next), is_empty_line(next)
                                              ? "empty line, expected a row of " + counted(columns, "field")
                                              : "row has " + counted(next.fields.size(), "field") + ", expected " +
                                                    std::to_string(columns) + " as in the header");
            table.rows.push_back(std::move(next));
        }
        return table;
    }

private:
    std::string comment()
    {
        ++next_;
        if (at(' '))
            ++next_;
        const std::size_t begin = next_;
        for (; !ended() && !at_line_end(); ++next_)
            require_text(text_[next_]);
        const std::string_view words = text_.substr(begin, next_ - begin);
        take_line_end();
        return std::string(words);
    }

    CsvRow header()
    {
        if (ended())
            refuse(place(), "the file ends here, expected a header with the names of the columns");
        CsvRow names = row(0);
        if (is_empty_line(names))
            refuse({path_, names.line}, "empty line, expected the names of the columns");
        std::vector<std::string> sorted = names.fields;
        std::sort(sorted.begin(), sorted.end());
        const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
        if (twin != sorted.end())
            refuse({path_, names.line}, "two columns are named " + in_quotes(*twin) + ", expected different names");
        return names;
    }

    CsvRow row(std::size_t fields_to_expect)
    {
        CsvRow row;
        row.fields.reserve(fields_to_expect);
        row.line = line_;
        for (;;) {
            row.fields.push_back(at('"') ? quoted_field() : plain_field());
            if (ended() || take_line_end())
                return row;
            if (!at(','))
                refuse(place(), "text after a closing quote, expected a comma or the end of the line");
            ++next_;
        }
    }

    std::string plain_field()
    {
        const std::size_t begin = next_;
        for (; !ended() && !at(',') && !at_line_end(); ++next_) {
            require_text(text_[next_]);
            if (at('"'))
                refuse(place(), "quote inside a field, expected the whole field in quotes and this one doubled");
        }
        return std::string(text_.substr(begin, next_ - begin));
    }

    std::string quoted_field()
    {
        const TextLocation opening = place();
        std::string field;
        do {
            ++next_; // the opening quote, or the second of a doubled quote
            const std::size_t begin = next_;
            for (; !ended() && !at('"'); ++next_) {
                if (at('\n'))
                    ++line_;
                else if (!at_line_end())
                    require_text(text_[next_]);
            }
            if (ended())
                refuse(opening, "quote without end, expected a closing quote before the end of the file");
            field += text_.substr(begin, next_ - begin);
            ++next_;
            if (at('"'))
                field += '"';
        } while (at('"'));
        return field;
    }

    void require_text(char c) const
    {
        if (c == '\r')
            refuse(place(), "carriage return inside a line, expected lines that end in LF or CRLF");
        if (static_cast<unsigned char>(c) < ' ' && !is_blank(c))
            refuse(place(), "control character, expected a text file (is it binary or damaged?)");
    }

    bool take_line_end()
    {
        if (!at_line_end())
            return false;
        next_ += at('\r') ? 2 : 1;
        ++line_;
        return true;
    }

    bool ended() const { return next_ == text_.size(); }
    bool at(char c) const { return !ended() && text_[next_] == c; }
    bool at_line_end() const { return at('\n') || (at('\r') && text_.substr(next_ + 1, 1) == "\n"); }
    TextLocation place() const { return {path_, line_}; }

    const std::string_view text_;
    const std::string& path_;
    std::size_t next_ = 0;
    std::uint32_t line_ = 1;
};

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
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.17g", value == 0.0 ? 0.0 : value);
    row += text.data();
}

std::string csv_field(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
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

CsvTable parse_csv(std::string_view text, const std::string& path)
{
    return CsvParser(text, path).parse();
}

CsvTable read_csv(const std::string& path)
{
    TextLines lines(path, false);
    std::string text;
    TextLine line;
    while (lines.next(line))
        text.append(line.text).append(line.ended ? "\n" : "");
    return parse_csv(text, path);
}

} // namespace multipath
