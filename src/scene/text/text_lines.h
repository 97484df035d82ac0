#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The position of a line in a text file, for messages. The path must outlive it.
struct TextLocation
{
    std::string_view path;
    std::uint32_t line = 0; ///< from 1; 0 means the file as a whole
};

/// "room.obj:12", or "room.obj" for the file as a whole.
std::string name_of(TextLocation place);

/// Throws InputError with the message "room.obj:12: problem".
[[noreturn]] void refuse(TextLocation place, const std::string& problem);

/// A word of a file, made safe for a message: in backquotes, `?` for control characters, cut after 60 bytes.
std::string in_quotes(std::string_view word);

/// A statement of a file, without its line end.
struct TextLine
{
    std::string_view text; ///< valid until the next line is read
    TextLocation place;    ///< its first line, if it was continued
    bool ended = true;     ///< false only for a last line without a line end
};

/// Reads the statements of a Wavefront OBJ or MTL file one by one. Accepts any kind of line end and UTF-8 with or
/// without a byte order mark, and joins lines continued by a backslash (except in names and comments). Memory is
/// proportional to the longest line.
class TextLines
{
public:
    static constexpr std::size_t longest_line = std::size_t{16} << 20; ///< [byte]

    /// Throws InputError for a file that cannot be read, is a directory or is not UTF-8 text.
    explicit TextLines(const std::string& path);

    /// Reads the next statement; returns false after the last. Throws InputError for binary data, a line longer than
    /// longest_line, and a file that ends after a continuation backslash.
    bool next(TextLine& line);

    /// [1] The share of the file that was returned so far; 0 if the size of the file is not known.
    double share_read() const;

private:
    struct Closer
    {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    bool physical_line(std::string_view& text);
    std::size_t scan_to_end_of_line(std::size_t length) const;
    bool refill();
    TextLine join_continued(std::string_view first);
    TextLocation place() const { return {path_, number_}; }

    std::string path_;
    std::unique_ptr<std::FILE, Closer> file_;
    std::vector<char> buffer_;
    double size_ = 0.0;          ///< [byte] of the file, 0 if not known
    std::uint64_t buffered_ = 0; ///< [byte] read into the buffer so far
    std::size_t begin_ = 0;      ///< [begin_, end_) of the buffer is not yet returned
    std::size_t end_ = 0;
    std::uint32_t number_ = 0;
    bool after_carriage_return_ = false;
    bool ended_ = true;
    std::string joined_;
};

} // namespace multipath
