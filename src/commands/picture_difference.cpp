#include "commands/result_difference.h"

#include "image/image.h"
#include "image/png_chunks.h"
#include "scene/text_format.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace multipath {

namespace {

constexpr const char* damaged_text = "the picture is damaged";

/// A file as ppm_bytes() writes it; nothing for any other.
std::optional<ScreenImage> read_ppm(const std::string& bytes)
{
    ScreenImage image;
    std::size_t begin = std::strlen("P6\n");
    if (bytes.compare(begin, 1, "#") == 0)
        begin = bytes.find('\n', begin) + 1;
    int header = 0;
    if (begin == 0 || begin >= bytes.size() ||
        std::sscanf(bytes.c_str() + begin, "%5d %5d\n255%n", &image.width, &image.height, &header) != 2 || header == 0)
        return std::nullopt;
    begin += static_cast<std::size_t>(header) + 1;
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width < 1 || image.height < 1 || bytes.size() != begin + 3 * pixels)
        return std::nullopt;
    image.bytes.assign(bytes.begin() + static_cast<std::ptrdiff_t>(begin), bytes.end());
    return image;
}

std::string size_text(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

std::string pixel_difference(const ScreenImage& then, const ScreenImage& now)
{
    const std::size_t pixels = then.bytes.size() / 3;
    std::size_t count = 0;
    std::size_t first = 0;
    int largest = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        int difference = 0;
        for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
            difference = std::max(difference, std::abs(then.bytes[k] - now.bytes[k]));
        if (difference > 0 && ++count == 1)
            first = i;
        largest = std::max(largest, difference);
    }
    if (count == 0)
        return "";
    const std::size_t width = static_cast<std::size_t>(then.width);
    return grouped(count) + " of " + grouped(pixels) +
           (count == 1 ? " pixels differs, that in column " : " pixels differ, first that in column ") +
           std::to_string(first % width) + " of row " + std::to_string(first / width) + " (both from 0), by " +
           (count == 1 ? "" : "at most ") + std::to_string(largest) + " of 255";
}

/// The data of all chunks of a type, joined.
std::string png_data(const std::string& bytes, std::string_view type)
{
    std::string data;
    for (const PngChunk& chunk : png_chunks(bytes))
        if (chunk.type == type)
            data += chunk.data;
    return data;
}

} // namespace

ResultDifference ppm_difference(const std::string& then, const std::string& now)
{
    const std::optional<ScreenImage> before = read_ppm(then);
    const std::optional<ScreenImage> after = read_ppm(now);
    if (!before || !after)
        return {damaged_text};
    if (before->width != after->width || before->height != after->height)
        return {"other size: then " + size_text(before->width, before->height) + ", now " +
                size_text(after->width, after->height)};
    return {pixel_difference(*before, *after)};
}

ResultDifference png_difference(const std::string& then, const std::string& now)
{
    if (png_data(then, "IHDR") != png_data(now, "IHDR"))
        return {"other size or format of the picture"};
    const std::string before = png_data(then, "IDAT");
    const std::string after = png_data(now, "IDAT");
    if (before.empty() || after.empty())
        return {damaged_text};
    if (before == after)
        return {};
    const auto place = std::mismatch(before.begin(), before.end(), after.begin(), after.end()).first - before.begin();
    return {"other pixels: compressed " + grouped(before.size()) + " bytes then, " + grouped(after.size()) +
            " now, the same up to byte " + grouped(static_cast<std::uint64_t>(place))};
}

} // namespace multipath
