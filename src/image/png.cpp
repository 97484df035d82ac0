// PNG (ISO/IEC 15948): a signature and chunks. Each row is first turned into differences from its neighbours by one of
// five filters, then all rows are compressed together.

#include "image/png.h"

#include "image/big_endian.h"
#include "image/checksum.h"
#include "image/deflate.h"
#include "image/png_chunks.h"
#include "scene/utf8.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace multipath {

namespace {

constexpr std::size_t channels = 3;

std::string chunk(const std::string& type, const std::string& data)
{
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc32(type + data));
}

/// Of left, above and upper left, the one closest to left + above - upper left.
int paeth(int left, int above, int upper_left)
{
    const int to_left = std::abs(above - upper_left);
    const int to_above = std::abs(left - upper_left);
    const int to_upper_left = std::abs(left + above - 2 * upper_left);
    if (to_left <= to_above && to_left <= to_upper_left)
        return left;
    return to_above <= to_upper_left ? above : upper_left;
}

int predicted(int filter, int left, int above, int upper_left)
{
    switch (filter) {
    case 1:
        return left;
    case 2:
        return above;
    case 3:
        return (left + above) / 2;
    case 4:
        return paeth(left, above, upper_left);
    default:
        return 0;
    }
}

/// One row as filter number and differences; `row` and `above` start with one pixel of zeros.
std::string filtered(const std::vector<std::uint8_t>& row, const std::vector<std::uint8_t>& above, int filter)
{
    std::string result(1, static_cast<char>(filter));
    for (std::size_t i = channels; i < row.size(); ++i)
        result += static_cast<char>(row[i] - predicted(filter, row[i - channels], above[i], above[i - channels]));
    return result;
}

/// Small differences of either sign compress well.
std::uint64_t cost(const std::string& filtered_row)
{
    std::uint64_t sum = 0;
    for (std::size_t i = 1; i < filtered_row.size(); ++i)
        sum += static_cast<std::uint64_t>(std::abs(static_cast<int>(static_cast<signed char>(filtered_row[i]))));
    return sum;
}

std::string filtered_rows(const ScreenImage& image)
{
    const std::size_t row_size = channels * static_cast<std::size_t>(image.width);
    std::vector<std::uint8_t> above(channels + row_size, 0);
    std::vector<std::uint8_t> row(channels + row_size, 0);
    std::string result;
    for (std::size_t first = 0; first < image.bytes.size(); first += row_size) {
        std::copy_n(image.bytes.begin() + static_cast<std::ptrdiff_t>(first), row_size, row.begin() + channels);
        std::string best = filtered(row, above, 0);
        for (int filter = 1; filter <= 4; ++filter) {
            std::string candidate = filtered(row, above, filter);
            if (cost(candidate) < cost(best))
                best.swap(candidate);
        }
        result += best;
        above.swap(row);
    }
    return result;
}

/// Without control characters but line feeds, which end lines in a PNG.
std::string clean_text(std::string_view text)
{
    std::string result;
    while (!text.empty()) {
        const std::size_t size = utf8_character_size(text);
        const bool control = size == 1 && text[0] != '\n' && (text[0] < ' ' || text[0] == '\x7f');
        result += size == 0 || control ? "?" : text.substr(0, size);
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return result;
}

/// Older readers know only the plain chunk, which has no room for more than ASCII in UTF-8.
std::string comment_chunk(const std::string& comment)
{
    const std::string text = clean_text(comment);
    const bool ascii =
        std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    return ascii ? chunk("tEXt", std::string(plain_comment) + text) : chunk("iTXt", std::string(utf8_comment) + text);
}

} // namespace

std::string png_bytes(const ScreenImage& image, const std::string& comment)
{
    // 8 bits per channel, red green blue, and the only compression, filter set and (no) interlacing of the format.
    const std::string format = {8, 2, 0, 0, 0};
    std::string bytes(png_signature);
    bytes += chunk("IHDR", big_endian(static_cast<std::uint32_t>(image.width)) +
                               big_endian(static_cast<std::uint32_t>(image.height)) + format);
    bytes += chunk("sRGB", std::string(1, '\0'));
    if (!comment.empty())
        bytes += comment_chunk(comment);
    bytes += chunk("IDAT", zlib_bytes(filtered_rows(image)));
    bytes += chunk("IEND", "");
    return bytes;
}

} // namespace multipath
