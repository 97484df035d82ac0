// Reader of Netpbm files: bitmaps (P1, P4), grey maps (P2, P5) and colour maps (P3, P6), as text (P1 to P3) or binary.

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
        is_bitmap_ = kind == 1 || kind == 4;
        const bool is_grey = kind == 2 || kind == 5;
        const std::uint32_t width = number();
        const std::uint32_t height = number();
        largest_ = is_bitmap_ ? 1 : number();
        if (largest_ < 1 || largest_ > 65535)
            throw ImageError("has a largest value of " + std::to_string(largest_) + ", expected 1 to 65535");

        const std::size_t samples = is_bitmap_ || is_grey ? 1 : 3;           // of a pixel
        if (std::uint64_t{width} * height > 8 * std::uint64_t{file_.left()}) // before memory is allocated
            throw ImageError("ends too early");
        Bitmap bitmap = blank_bitmap(width, height);
        for (std::uint32_t y = 0; y < height; ++y) {
            const std::uint8_t* const bits = is_bitmap_ && !is_text_ ? file_.bytes((width + 7) / 8) : nullptr;
            for (std::uint32_t x = 0; x < width; ++x) {
                const std::uint8_t first = bits != nullptr ? level_of_bit(packed_number(bits, x, 1)) : level();
                const std::uint8_t second = samples == 1 ? first : level();
                bitmap.set(x, y, {first, second, samples == 1 ? first : level()});
            }
        }
        return bitmap;
    }

private:
    static std::uint8_t level_of_bit(unsigned bit) { return bit == 0 ? 255 : 0; } ///< 1 is black

    /// The next value, scaled to 0 ... 255, unless it is a single bit.
    std::uint8_t level()
    {
        if (is_bitmap_)
            return level_of_bit(digit());
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

    /// Skips white space and returns the value of the digit that follows.
    unsigned digit()
    {
        std::uint8_t c = character();
        while (c == ' ' || (c >= '\t' && c <= '\r'))
            c = character();
        if (c < '0' || c > '9')
            throw ImageError("has other text where a number is expected");
        return c - unsigned{'0'};
    }

    /// Reads a number and the single character after it, which is all that separates the header from binary values.
    std::uint32_t number()
    {
        std::uint32_t value = digit();
        while (file_.left() > 0) {
            const std::uint8_t c = character();
            if (c < '0' || c > '9')
                break;
            value = 10 * value + (c - std::uint32_t{'0'});
            if (value > 100000000)
                throw ImageError("has a number that is too large");
        }
        return value;
    }

    ByteReader file_;
    bool is_text_ = false;
    bool is_bitmap_ = false;
    std::uint32_t largest_ = 1;
};

} // namespace

Bitmap read_pnm(std::string_view bytes)
{
    return PnmReader(bytes).read();
}

} // namespace multipath
