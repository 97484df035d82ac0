// Reader of Netpbm files: grey maps and colour maps, as text (P2, P3) or binary (P5, P6).

#include "base/errors.h"
#include "scene/texture/byte_reader.h"
#include "scene/texture/image_formats.h"

#include <algorithm>

namespace multipath {

namespace {

class PnmReader
{
public:
    explicit PnmReader(std::string_view bytes) : file_(bytes) {}

    Bitmap read()
    {
        file_.skip(1); // 'P'
        const unsigned kind = file_.byte() - unsigned{'0'};
        is_text_ = kind <= 3;
        const bool is_grey = kind == 2 || kind == 5;
        const std::uint32_t width = number();
        const std::uint32_t height = number();
        largest_ = number();
        if (largest_ < 1 || largest_ > 65535)
            throw ImageError("has a largest value of " + std::to_string(largest_) + ", expected 1 to 65535");

        if (std::uint64_t{width} * height > file_.left()) // before memory is allocated
            throw ImageError("ends too early");
        Bitmap bitmap = blank_bitmap(width, height);
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x) {
                const std::uint8_t first = level();
                const std::uint8_t second = is_grey ? first : level();
                bitmap.set(x, y, {first, second, is_grey ? first : level()});
            }
        return bitmap;
    }

private:
    /// The next value, scaled to 0 ... 255.
    std::uint8_t level()
    {
        const std::uint32_t value = std::min(is_text_ ? number() : binary(), largest_);
        return static_cast<std::uint8_t>((value * 255 + largest_ / 2) / largest_);
    }

    std::uint32_t binary()
    {
        const std::uint32_t high = file_.byte();
        return largest_ > 255 ? high << 8 | file_.byte() : high;
    }

    /// The next character; a comment, up to the end of its line, counts as a single white space.
    std::uint8_t character()
    {
        std::uint8_t c = file_.byte();
        if (c == '#')
            while (c != '\n' && c != '\r')
                c = file_.byte();
        return c;
    }

    /// Reads a number after white space, and the single character after it, which is all that separates the header from
    /// binary values.
    std::uint32_t number()
    {
        const auto is_digit = [](std::uint8_t c) { return c >= '0' && c <= '9'; };
        std::uint8_t c = character();
        while (c == ' ' || (c >= '\t' && c <= '\r'))
            c = character();
        if (!is_digit(c))
            throw ImageError("has other text where a number is expected");
        std::uint32_t value = 0;
        for (; is_digit(c); c = file_.left() > 0 ? character() : std::uint8_t{'\n'}) {
            value = 10 * value + (c - std::uint32_t{'0'});
            if (value > 100000000)
                throw ImageError("has a number that is too large");
        }
        return value;
    }

    ByteReader file_;
    bool is_text_ = false;
    std::uint32_t largest_ = 1;
};

} // namespace

Bitmap read_pnm(std::string_view bytes)
{
    return PnmReader(bytes).read();
}

} // namespace multipath
