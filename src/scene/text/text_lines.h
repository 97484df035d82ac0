#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace multipath {

/// A line of a text file, for messages. The path is not copied: it must outlive this object.
struct TextLocation
{
    std::string_view path;
    std::uint32_t line = 0; ///< counted from 1; 0 means the file as a whole
};

/// "room.obj:12", or "room.obj" for the file as a whole.
std::string name_of(TextLocation place);

/// Throws InputError with a message such as "room.obj:12: problem".
[[noreturn]] void refuse(TextLocation place, const std::string& problem);

/// A word of a file, made safe for a message: in backquotes, with `?` for control characters, and cut after 60 bytes
/// with "..." at the end.
std::string in_quotes(std::string_view word);

/// A statement of a file, without its line end.
struct TextLine
{
    std::string_view text; ///< valid until the next line is read
    TextLocation place;    ///< the first line of the statement
    bool ended = true;     ///< false for a last line without a line end, else true
};

/// Reads the statements of a Wavefront OBJ or MTL file, or the lines of another text file, one by one. Accepts any kind
/// of line end and UTF-8 with or without a byte order mark. A backslash at the end of a line continues the statement on
/// the next line, unless the statement takes a name or contains a `#`.
class TextLines
{
public:
    static constexpr std::size_t longest_line = std::size_t{16} << 20; ///< [bytes]

    /// Throws InputError for a file that cannot be read. `joins_lines`: joins lines continued by a backslash; false for
    /// files that do not have such lines.
    explicit TextLines(const std::string& path, bool joins_lines = true);
    TextLines(const TextLines&) = delete;
    TextLines& operator=(const TextLines&) = delete;

    /// Reads the next statement; returns false after the last one. Throws InputError for a control character other than
    /// blanks and line ends, a line longer than longest_line, and a file that ends after a continuation backslash.
    bool next(TextLine& line);

    std::size_t file_size() const { return file_.size(); } ///< [bytes]

private:
    bool physical_line(std::string_view& text);
    std::size_t length_of_line() const;
    TextLine join_continued(std::string_view first);
    TextLocation place() const { return {path_, number_}; }

    std::string path_;
    bool joins_lines_;
    std::string file_;
    std::string_view rest_;    ///< not yet returned
    std::uint32_t number_ = 0; ///< of the last line that was returned
    bool ended_ = true;        ///< see TextLine::ended
    std::string joined_;       ///< the last statement, if it was continued
};

} // namespace multipath
