// PNG (ISO/IEC 15948) is a signature followed by chunks. Each row is filtered: stored as differences from the pixel to
// the left or from the row above. All rows together are compressed with deflate (RFC 1951), as literals and copies of
// earlier bytes (Ziv and Lempel 1977), here in a single block with the fixed Huffman code of the format. Matches are
// found with hash chains and chosen by lazy matching.

#include "image/png.h"

#include "base/checksum.h"
#include "base/text_format.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace multipath {

namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";

/// Start of the data of a comment chunk (ISO/IEC 15948, 11.3.4): the keyword and, in the UTF-8 form (iTXt), flags for
/// no compression and empty language fields.
constexpr std::string_view plain_comment("Comment\0", 8);
constexpr std::string_view utf8_comment("Comment\0\0\0\0\0", 12);

/// Four bytes, most significant first.
std::string big_endian(std::uint32_t value)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>((value >> shift) & 0xffu);
    return bytes;
}

struct CodeWord
{
    std::uint16_t bits = 0; ///< first bit of the code word in the lowest bit, as deflate stores it
    std::uint8_t length = 0;
};

CodeWord code_word(std::uint32_t number, int length)
{
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < length; ++bit)
        reversed |= (number >> bit & 1u) << (length - 1 - bit);
    return {static_cast<std::uint16_t>(reversed), static_cast<std::uint8_t>(length)};
}

/// The fixed Huffman code of literals, end of block and lengths (RFC 1951, section 3.2.6).
CodeWord fixed_code(std::uint32_t symbol)
{
    return symbol < 144   ? code_word(0x30 + symbol, 8)
           : symbol < 256 ? code_word(0x190 + symbol - 144, 9)
           : symbol < 280 ? code_word(symbol - 256, 7)
                          : code_word(0xc0 + symbol - 280, 8);
}

constexpr std::uint32_t end_of_data = 256;

constexpr std::size_t window = 32768; ///< greatest distance of a copy
constexpr std::size_t shortest_copy = 3;
constexpr std::size_t longest_copy = 258;

/// Writes a deflate stream of one block.
class DeflateWriter
{
public:
    DeflateWriter() { put(1 | 1 << 1, 3); } // block header: last block, fixed Huffman code

    void literal(char byte) { put(fixed_code(static_cast<unsigned char>(byte))); }

    void copy(std::size_t length, std::size_t distance)
    {
        if (length == longest_copy) {
            put(fixed_code(285));
        } else {
            const Range range = doubling_range(static_cast<std::uint32_t>(length - shortest_copy), 4);
            put(fixed_code(257 + range.code));
            put(range.offset, range.offset_bits);
        }
        const Range range = doubling_range(static_cast<std::uint32_t>(distance - 1), 2);
        put(code_word(range.code, 5));
        put(range.offset, range.offset_bits);
    }

    std::string finished()
    {
        put(fixed_code(end_of_data));
        put(0, 7); // completes the last byte
        return std::move(bytes_);
    }

private:
    struct Range
    {
        std::uint32_t code;
        std::uint32_t offset; ///< of the value from the start of the range
        int offset_bits;
    };

    /// Code and extra bits of a length or distance, counted from zero: ranges double in size every `per_size` codes.
    static Range doubling_range(std::uint32_t value, std::uint32_t per_size)
    {
        int bits = 0;
        while (value >> bits >= 2 * per_size)
            ++bits;
        return {static_cast<std::uint32_t>(bits) * per_size + (value >> bits), value & ((1u << bits) - 1u), bits};
    }

    void put(CodeWord word) { put(word.bits, word.length); }
    /// Appends bits; bytes are filled from the lowest bit.
    void put(std::uint32_t bits, int count)
    {
        buffer_ |= std::uint64_t{bits} << filled_;
        for (filled_ += count; filled_ >= 8; filled_ -= 8, buffer_ >>= 8)
            bytes_ += static_cast<char>(buffer_ & 0xffu);
    }

    std::string bytes_;
    std::uint64_t buffer_ = 0;
    int filled_ = 0;
};

/// Finds earlier occurrences of strings with hash chains: linked lists of the positions whose first three bytes have
/// the same hash.
class MatchFinder
{
public:
    explicit MatchFinder(const std::string& bytes)
        : bytes_(bytes), newest_(std::size_t{1} << hash_bits, none), older_(window)
    {
    }

    /// Adds a position to its chain. Positions must be added in order.
    void add(std::size_t position)
    {
        if (position + shortest_copy > bytes_.size())
            return;
        std::uint32_t& newest = newest_[hash(position)];
        older_[position % window] = newest;
        newest = static_cast<std::uint32_t>(position);
    }

    struct Match
    {
        std::size_t length = 0;
        std::size_t distance = 0;
    };

    /// The longest match for the bytes at `position` that is longer than `to_beat`; length 0 if there is none.
    Match longest(std::size_t position, std::size_t to_beat) const
    {
        const std::size_t limit = std::min(longest_copy, bytes_.size() - position);
        if (limit < shortest_copy)
            return {};
        Match best;
        to_beat = std::max(to_beat, shortest_copy - 1);
        std::uint32_t earlier = newest_[hash(position)];
        for (int step = 0; step < chain_limit && earlier != none && to_beat < limit; ++step) {
            const std::size_t distance = position - earlier;
            if (distance > window)
                break;
            const std::size_t length = common_length(earlier, position, limit, to_beat);
            if (length > to_beat && !(length == shortest_copy && distance > far)) {
                best = {length, distance};
                to_beat = length;
            }
            earlier = older_[earlier % window];
        }
        return best;
    }

private:
    static constexpr int hash_bits = 15;
    static constexpr std::uint32_t none = 0xffffffffu;
    static constexpr int chain_limit = 128;  ///< number of earlier positions to compare; tuned on pictures
    static constexpr std::size_t far = 8192; ///< copies of three bytes from farther away save no bits over literals

    std::size_t hash(std::size_t position) const
    {
        const auto byte = [&](std::size_t n) {
            return std::uint32_t{static_cast<unsigned char>(bytes_[position + n])};
        };
        return (byte(0) | byte(1) << 8 | byte(2) << 16) * 0x9e3779b1u >> (32 - hash_bits);
    }

    /// Number of equal bytes, up to `limit`, or some number <= to_beat if there are no more than that. Most candidates
    /// are rejected by the one byte that would exceed `to_beat`.
    std::size_t common_length(std::size_t a, std::size_t b, std::size_t limit, std::size_t to_beat) const
    {
        if (bytes_[a + to_beat] != bytes_[b + to_beat])
            return 0;
        std::size_t length = 0;
        while (length < limit && bytes_[a + length] == bytes_[b + length])
            ++length;
        return length;
    }

    const std::string& bytes_;
    std::vector<std::uint32_t> newest_; ///< per hash
    std::vector<std::uint32_t> older_;  ///< per position modulo the window: the position before it with the same hash
};

/// Compresses bytes to a zlib stream (RFC 1950): header, deflate stream, Adler-32. A match is used only if the next
/// position has no longer one (lazy matching, RFC 1951, section 4).
std::string compressed(const std::string& bytes)
{
    constexpr std::size_t no_delay = 16; // matches of this length are used without looking at the next position
    DeflateWriter writer;
    MatchFinder finder(bytes);
    MatchFinder::Match match;
    for (std::size_t position = 0; position < bytes.size();) {
        finder.add(position);
        const MatchFinder::Match next =
            match.length < no_delay ? finder.longest(position + 1, match.length) : MatchFinder::Match{};
        if (match.length == 0 || next.length > 0) {
            writer.literal(bytes[position++]);
            match = next;
            continue;
        }
        writer.copy(match.length, match.distance);
        const std::size_t end = position + match.length;
        while (++position < end)
            finder.add(position);
        match = finder.longest(position, 0);
    }
    const std::string header = "\x78\x9c"; // deflate with a window of 32768 bytes, check bits
    return header + writer.finished() + big_endian(adler32(bytes));
}

/// The filtered rows, each after the number of its filter: 1, differences from the left, or 2, from above. The filter
/// from above must have clearly more zeros to be chosen: with the dither pattern of tone_map.cpp, differences from the
/// left repeat along smooth walls and compress well.
std::string filtered_rows(const ScreenImage& image)
{
    constexpr std::size_t channels = 3;
    const std::size_t row_size = channels * static_cast<std::size_t>(image.width);
    const std::vector<std::uint8_t>& bytes = image.bytes;
    const auto changes = [](const std::string& row) {
        return std::count_if(row.begin(), row.end(), [](char c) { return c != 0; });
    };
    std::string result;
    result.reserve(bytes.size() + static_cast<std::size_t>(image.height));
    for (std::size_t first = 0; first < bytes.size(); first += row_size) {
        std::string from_left = "\1";
        std::string from_above = "\2";
        for (std::size_t i = first; i < first + row_size; ++i) {
            from_left += static_cast<char>(bytes[i] - (i >= first + channels ? bytes[i - channels] : 0));
            from_above += static_cast<char>(bytes[i] - (first > 0 ? bytes[i - row_size] : 0));
        }
        result += 4 * changes(from_above) < 3 * changes(from_left) ? from_above : from_left;
    }
    return result;
}

std::string chunk(const std::string& type, const std::string& data)
{
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc32(type + data));
}

/// A chunk with a comment: the older tEXt, which all readers know, for ASCII; iTXt for other text.
std::string comment_chunk(const std::string& comment)
{
    const std::string text = without_controls(valid_utf8(comment), "\n");
    const bool ascii =
        std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    return ascii ? chunk("tEXt", std::string(plain_comment) + text) : chunk("iTXt", std::string(utf8_comment) + text);
}

} // namespace

std::string png_bytes(const ScreenImage& image, const std::string& comment)
{
    // 8 bits per channel; colour type RGB; compression and filter method 0, the only ones; no interlacing.
    const std::string format = {8, 2, 0, 0, 0};
    std::string bytes(signature);
    bytes += chunk("IHDR", big_endian(static_cast<std::uint32_t>(image.width)) +
                               big_endian(static_cast<std::uint32_t>(image.height)) + format);
    bytes += chunk("sRGB", std::string(1, '\0'));
    if (!comment.empty())
        bytes += comment_chunk(comment);
    bytes += chunk("IDAT", compressed(filtered_rows(image)));
    bytes += chunk("IEND", "");
    return bytes;
}

std::vector<ImageFile> texture_files(const Scene& scene)
{
    std::vector<ImageFile> images;
    for (const std::shared_ptr<const Texture>& texture : scene.file().textures) {
        const std::string& bytes = texture->bytes();
        const Bitmap& bitmap = texture->bitmap();
        if (bytes.compare(0, 3, "\xff\xd8\xff") == 0 && !bitmap.is_of_inks)
            images.push_back({"image/jpeg", bytes});
        else if (bytes.compare(0, 4, "\x89PNG") == 0)
            images.push_back({"image/png", bytes});
        else
            images.push_back({"image/png", png_bytes({static_cast<int>(bitmap.width), static_cast<int>(bitmap.height),
                                                      bitmap.rgb})});
    }
    return images;
}

} // namespace multipath
