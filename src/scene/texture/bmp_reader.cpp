// Reader of uncompressed Windows bitmaps with a BITMAPINFOHEADER, whose later versions only append fields.

#include "base/errors.h"
#include "scene/texture/byte_reader.h"
#include "scene/texture/image_formats.h"

#include <algorithm>
#include <array>
#include <optional>

namespace multipath {

namespace {

class BmpReader
{
public:
    explicit BmpReader(std::string_view bytes) : bytes_(bytes) {}

    Bitmap read()
    {
        ByteReader file(bytes_);
        file.skip(10); // mark, size, reserved
        const std::uint32_t pixel_offset = file.little_endian_32();
        const std::uint32_t header_size = file.little_endian_32();
        if (header_size < info_size)
            throw ImageError("has an unknown kind of header");
        read_header(file, header_size);
        if (bits_ <= 8)
            read_palette(header_size);
        ByteReader data(bytes_);
        data.skip(pixel_offset);
        return read_rows(data);
    }

private:
    static constexpr std::uint32_t info_size = 40;
    static constexpr std::uint32_t size_with_alpha_mask = 56;

    enum Compression : std::uint32_t { none = 0, bit_fields = 3 };
    using Colour = Bitmap::Colour;

    void read_header(ByteReader& file, std::uint32_t header_size)
    {
        width_ = file.little_endian_32();
        height_ = file.little_endian_32();
        is_from_top_ = height_ > 0x7fffffffu; // negative
        if (is_from_top_)
            height_ = 0u - height_;
        file.skip(2); // planes
        bits_ = file.little_endian_16();
        const std::uint32_t compression = file.little_endian_32();
        file.skip(12); // size in bytes, pixels per metre
        colours_used_ = file.little_endian_32();
        file.skip(4); // important colours
        if (width_ == 0 || width_ > 0x7fffffffu || height_ == 0)
            throw ImageError("has no pixels");
        constexpr std::array<unsigned, 5> known = {1, 4, 8, 24, 32};
        if (std::find(known.begin(), known.end(), bits_) == known.end())
            throw ImageError(std::to_string(bits_) + " bits per pixel are not supported");
        const bool has_masks = compression == bit_fields && bits_ == 32;
        if (compression != none && !has_masks)
            throw ImageError("uses a compression method that is not supported");
        // The masks follow the first 40 bytes, which are the whole header or the beginning of that of a later version.
        if (has_masks)
            for (std::size_t& place : colour_bytes_)
                place = byte_of_mask(file.little_endian_32());
        if (has_masks && header_size >= size_with_alpha_mask)
            if (const std::uint32_t mask = file.little_endian_32(); mask != 0)
                alpha_byte_ = byte_of_mask(mask);
    }

    /// The byte of a pixel that is all that a mask covers.
    static std::size_t byte_of_mask(std::uint32_t mask)
    {
        for (std::size_t byte = 0; byte < 4; ++byte)
            if (mask == 0xffu << 8 * byte)
                return byte;
        throw ImageError("has colours that are not whole bytes, which is not supported");
    }

    void read_palette(std::uint32_t header_size)
    {
        ByteReader file(bytes_);
        file.skip(14); // header of the file
        file.skip(header_size);
        const std::uint32_t most = 1u << bits_;
        const std::uint32_t count = colours_used_ == 0 ? most : std::min(colours_used_, most);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint8_t* const entry = file.bytes(4);
            palette_[i] = {entry[2], entry[1], entry[0]};
        }
    }

    Bitmap read_rows(ByteReader& data) const
    {
        const std::uint64_t row_bits = std::uint64_t{width_} * bits_;
        const std::uint64_t row_bytes = (row_bits + 7) / 8;
        const std::uint64_t stride = (row_bits + 31) / 32 * 4;
        const std::uint64_t padding = stride - row_bytes; // may be missing after the last row
        if ((data.left() + padding) / stride < height_)
            throw ImageError("ends too early");
        Bitmap bitmap = blank_bitmap(width_, height_, alpha_byte_.has_value());
        for (std::uint32_t j = 0; j < height_; ++j) {
            const std::uint8_t* const row = data.bytes(static_cast<std::size_t>(row_bytes));
            data.skip(std::min(static_cast<std::size_t>(padding), data.left()));
            const std::uint32_t y = is_from_top_ ? j : height_ - 1 - j;
            for (std::uint32_t i = 0; i < width_; ++i) {
                const std::uint8_t* const pixel = row + std::size_t{bits_ / 8} * i; // unless it is of the palette
                const Colour colour =
                    bits_ <= 8 ? palette_[packed_number(row, i, bits_)]
                               : Colour{pixel[colour_bytes_[0]], pixel[colour_bytes_[1]], pixel[colour_bytes_[2]]};
                bitmap.set(i, y, colour, alpha_byte_ ? pixel[*alpha_byte_] : 255);
            }
        }
        drop_unused_alpha(bitmap);
        return bitmap;
    }

    std::string_view bytes_;
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    bool is_from_top_ = false;
    unsigned bits_ = 0;                                   ///< of a pixel
    std::uint32_t colours_used_ = 0;                      ///< 0 for all
    std::array<std::size_t, 3> colour_bytes_ = {2, 1, 0}; ///< places of red, green and blue in a pixel
    std::optional<std::size_t> alpha_byte_;               ///< without masks a fourth byte has no meaning
    std::array<Colour, 256> palette_ = {};                ///< black after its end
};

} // namespace

Bitmap read_bmp(std::string_view bytes)
{
    return BmpReader(bytes).read();
}

} // namespace multipath
