// The file is read into one buffer, and lines are returned as views into it. Before a refill the unfinished line moves
// to the front of the buffer, which grows only if a line does not fit. While the end of a line is searched for, eight
// bytes at a time are tested for control characters, which include line ends.

#include "scene/text/text_lines.h"

#include "base/errors.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace multipath {

namespace {

constexpr std::size_t first_buffer_size = std::size_t{1} << 18;

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
    return keyword.substr(0, 4) == "map_" || std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
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

bool looks_like_utf16(std::string_view start)
{
    if (start.size() < 2)
        return false;
    const std::string_view mark = start.substr(0, 2);
    return mark == "\xff\xfe" || mark == "\xfe\xff" || (mark[0] == '\0') != (mark[1] == '\0');
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
    std::string text = "`";
    for (const char c : word.substr(0, longest_quote))
        text += (static_cast<unsigned char>(c) < ' ' || c == '\x7f') ? '?' : c;
    return text + (word.size() > longest_quote ? "...`" : "`");
}

TextLines::TextLines(const std::string& path, bool joins_lines)
    : path_(path), joins_lines_(joins_lines), buffer_(first_buffer_size)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        refuse(place(), "is a directory, expected a file");
    file_.reset(std::fopen(path.c_str(), "rb"));
    if (!file_)
        refuse(place(), "cannot be opened: " + std::generic_category().message(errno));
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    size_ = ignored ? 0.0 : static_cast<double>(size);
    refill();
    const std::string_view start(buffer_.data(), end_);
    if (looks_like_utf16(start))
        refuse({path_, 1}, "is UTF-16 text, expected UTF-8: save the file as UTF-8");
    if (start.substr(0, 3) == "\xef\xbb\xbf")
        begin_ = 3;
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

double TextLines::share_read() const
{
    return size_ > 0.0 ? static_cast<double>(buffered_ - (end_ - begin_)) / size_ : 0.0;
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
    if (after_carriage_return_ && (begin_ < end_ || refill()) && buffer_[begin_] == '\n')
        ++begin_;
    std::size_t length = scan_to_end_of_line(0);
    while (length <= longest_line && begin_ + length == end_ && refill())
        length = scan_to_end_of_line(length);
    if (length > longest_line)
        refuse({path_, number_ + 1}, "line is longer than 16 MB");

    ended_ = begin_ + length < end_;
    if (!ended_ && length == 0)
        return false;
    text = {buffer_.data() + begin_, length};
    after_carriage_return_ = ended_ && buffer_[begin_ + length] == '\r';
    begin_ += length + (ended_ ? 1 : 0);
    ++number_;
    return true;
}

/// The length of the line that starts at begin_; up to end_ if it continues past the buffer. `length` was scanned
/// before.
std::size_t TextLines::scan_to_end_of_line(std::size_t length) const
{
    const char* const begin = buffer_.data() + begin_;
    const char* const end = buffer_.data() + end_;
    const char* p = begin + length;
    while (end - p >= 8 && has_no_controls(p))
        p += 8;
    for (; p != end && !is_line_end(*p); ++p)
        if (static_cast<unsigned char>(*p) < ' ' && !is_blank(*p))
            refuse({path_, number_ + 1}, "control character, expected a text file (is it binary or damaged?)");
    return static_cast<std::size_t>(p - begin);
}

/// Reads more of the file into the buffer; false at the end of the file.
bool TextLines::refill()
{
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
    if (end_ == buffer_.size())
        buffer_.resize(2 * buffer_.size());
    const std::size_t count = std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, file_.get());
    if (count == 0 && std::ferror(file_.get()) != 0)
        refuse(place(), "cannot be read: " + std::generic_category().message(errno));
    end_ += count;
    buffered_ += count;
    return count != 0;
}

} // namespace multipath
