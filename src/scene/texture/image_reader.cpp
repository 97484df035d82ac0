#include "base/errors.h"
#include "scene/text/text_words.h"
#include "scene/texture/image_formats.h"

#include <algorithm>

namespace multipath {

namespace {

bool begins_like_pnm(std::string_view bytes)
{
    using namespace std::string_view_literals;
    return bytes.size() >= 3 && bytes[0] == 'P' && "2356"sv.find(bytes[1]) != std::string_view::npos &&
           " \t\n\v\f\r"sv.find(bytes[2]) != std::string_view::npos;
}

} // namespace

void require_bitmap_size(std::uint32_t width, std::uint32_t height)
{
    const std::uint64_t pixels = std::uint64_t{width} * height;
    if (pixels == 0)
        throw ImageError("has no pixels");
    if (pixels > std::uint64_t{1} << 26 || width > 1u << 16)
        throw ImageError(std::to_string(width) + " x " + std::to_string(height) +
                         " pixels are too many, expected at most 2^26, and 2^16 in a row");
}

Bitmap blank_bitmap(std::uint32_t width, std::uint32_t height, bool has_alpha)
{
    require_bitmap_size(width, height);
    const std::size_t pixels = std::size_t{width} * height;
    return {width, height, std::vector<std::uint8_t>(3 * pixels), std::vector<std::uint8_t>(has_alpha ? pixels : 0)};
}

void drop_unused_alpha(Bitmap& bitmap)
{
    const auto is_zero = [](std::uint8_t alpha) { return alpha == 0; };
    if (std::all_of(bitmap.alpha.begin(), bitmap.alpha.end(), is_zero))
        bitmap.alpha.clear();
}

Bitmap read_image(std::string_view name, std::string_view bytes)
{
    if (bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n")
        return read_png(bytes);
    if (bytes.substr(0, 2) == "\xff\xd8")
        return read_jpeg(bytes);
    if (bytes.substr(0, 2) == "BM")
        return read_bmp(bytes);
    if (begins_like_pnm(bytes))
        return read_pnm(bytes);
    if (ends_in(name, ".tga"))
        return read_tga(bytes);
    throw ImageError("is not a PNG, JPEG, TGA, BMP or PPM file");
}

} // namespace multipath
