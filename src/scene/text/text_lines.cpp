// Lines are views into the bytes of the file. While the end of a line is searched for, eight bytes at a time are tested
// for control characters, which include line ends.

#include "scene/text/text_lines.h"

#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "scene/text/text_words.h"

#include <array>
#include <cstring>

namespace multipath {

namespace {

bool is_line_end(char c)
{
    return c == '\n' || c == '\r';
}

/// True if none of the eight bytes at p is below ' '. Subtracting ' ' from a byte sets its high bit only if the byte is
/// below ' ' or had that bit before, as in UTF-8.
bool has_no_controls(const char* p)
{
    constexpr std::uint64_t each_byte = 0x0101010101010101u;
    std::uint64_t eight = 0;
    std::memcpy(&eight, p, sizeof eight);
    return ((eight - ' ' * each_byte) & ~eight & 0x80 * each_byte) == 0;
}

/// True for statements with a name or path, which may itself end in a backslash.
bool takes_name(std::string_view keyword)
{
    constexpr std::array<std::string_view, 9> keywords = {"mtllib", "usemtl", "newmtl", "g",   "o",
                                                          "maplib", "usemap", "bump",   "disp"};
    return keyword.substr(0, 4) == "map_" || is_among(keyword, keywords);
}

bool ends_in_backslash(std::string_view text)
{
    const std::string_view trimmed_text = trimmed(text);
    return !trimmed_text.empty() && trimmed_text.back() == '\\' && text.find('#') == std::string_view::npos;
}

std::string_view without_backslash(std::string_view text)
{
    return text.substr(0, text.rfind('\\'));
}

} // namespace

std::string name_of(TextLocation place)
{
    std::string name(place.path);
    if (place.line != 0)
        name += ':' + std::to_string(place.line);
    return name;
}

void refuse(TextLocation place, const std::string& problem)
{
    throw InputError(name_of(place) + ": " + problem);
}

std::string in_quotes(std::string_view word)
{
    constexpr std::size_t longest_quote = 60;
    return "`" + without_controls(word.substr(0, longest_quote)) + (word.size() > longest_quote ? "...`" : "`");
}

TextLines::TextLines(const std::string& path, bool joins_lines)
    : path_(path), joins_lines_(joins_lines), file_(bytes_of_file(path)), rest_(file_)
{
    if (rest_.substr(0, 3) == "\xef\xbb\xbf")
        rest_.remove_prefix(3);
}

bool TextLines::next(TextLine& line)
{
    std::string_view text;
    if (!physical_line(text))
        return false;
    line = {text, place(), ended_};
    if (joins_lines_ && ends_in_backslash(text)) {
        std::string_view rest = text;
        if (!takes_name(next_word(rest)))
            line = join_continued(text);
    }
    return true;
}

TextLine TextLines::join_continued(std::string_view first)
{
    const TextLocation first_place = place();
    joined_ = without_backslash(first);
    for (bool more = true; more;) {
        std::string_view text;
        if (!physical_line(text))
            refuse(first_place, "the file ends after a `\\`, expected the rest of the line");
        if (joined_.size() + text.size() > longest_line)
            refuse(first_place, "continued line is longer than 16 MB");
        more = ends_in_backslash(text);
        joined_ += ' ';
        joined_ += more ? without_backslash(text) : text;
    }
    return {joined_, first_place, ended_};
}

bool TextLines::physical_line(std::string_view& text)
{
    if (rest_.empty())
        return false;
    text = rest_.substr(0, length_of_line());
    if (text.size() > longest_line)
        refuse({path_, number_ + 1}, "line is longer than 16 MB");
    rest_.remove_prefix(text.size());
    ended_ = !rest_.empty();
    if (ended_)
        rest_.remove_prefix(rest_.substr(0, 2) == "\r\n" ? 2 : 1);
    ++number_;
    return true;
}

std::size_t TextLines::length_of_line() const
{
    const char* const begin = rest_.data();
    const char* const end = begin + rest_.size();
    const char* p = begin;
    while (end - p >= 8 && has_no_controls(p))
        p += 8;
    for (; p != end && !is_line_end(*p); ++p)
        if (static_cast<unsigned char>(*p) < ' ' && !is_blank(*p))
            refuse({path_, number_ + 1},
                   "control character, expected text in UTF-8 (is the file UTF-16, binary or damaged?)");
    return static_cast<std::size_t>(p - begin);
}

} // namespace multipath
