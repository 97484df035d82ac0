#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// A line of a text file, for messages. The path must outlive it.
struct TextPlace
{
    std::string_view path;
    std::uint32_t line = 0; ///< from 1; 0 means the file as a whole
};

/// "room.obj:12"
std::string name_of(TextPlace place);

/// Throws InputError "room.obj:12: problem".
[[noreturn]] void refuse(TextPlace place, const std::string& problem);

/// A word of the file made fit for a message: in backquotes, without control characters, cut when long.
std::string in_quotes(std::string_view word);

/// One statement of a file, without the end of its line.
struct TextLine
{
    std::string_view text; ///< valid until the next line is read
    TextPlace place;       ///< of its first line, if it was continued
    bool ended = true;     ///< false only for a last line that lacks its line feed
};

/// The statements of a Wavefront OBJ or MTL file, one by one: any kind of line end, UTF-8 with or without mark, lines
/// continued by a backslash joined (except inside names and comments). Memory is bounded by the longest line.
class TextLines
{
public:
    static constexpr std::size_t longest_line = std::size_t{16} << 20; ///< [byte]

    /// Throws InputError for a file that cannot be read, is a directory or is not UTF-8 text.
    explicit TextLines(const std::string& path);

    /// False behind the last. Throws InputError at binary data, a line that is too long, or a file that ends behind a
    /// backslash.
    bool next(TextLine& line);

    /// How much of the file was handed out [1]; 0 where its size is not known beforehand.
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
    TextPlace place() const { return {path_, number_}; }

    std::string path_;
    std::unique_ptr<std::FILE, Closer> file_;
    std::vector<char> buffer_;
    double size_ = 0.0;          ///< [byte] of the file, 0 if not known
    std::uint64_t buffered_ = 0; ///< [byte] of it that came into the buffer so far
    std::size_t begin_ = 0;      ///< what is not yet handed out is [begin_, end_)
    std::size_t end_ = 0;
    std::uint32_t number_ = 0;
    bool after_carriage_return_ = false;
    bool ended_ = true;
    std::string joined_;
};

} // namespace multipath
