// Reader of Windows bitmaps with a BITMAPCOREHEADER or with a BITMAPINFOHEADER, whose later versions only append
// fields.

#include "base/errors.h"
#include "scene/texture/byte_reader.h"
#include "scene/texture/image_formats.h"

#include <algorithm>
#include <array>

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
        if (header_size == core_size)
            read_core_header(file);
        else if (header_size >= info_size)
            read_info_header(file, header_size);
        else
            throw ImageError("has an unknown kind of header");
        require_supported();
        if (bits_ <= 8)
            read_palette(header_size, pixel_offset);
        ByteReader data(bytes_);
        data.skip(pixel_offset);
        return compression_ == rle_8 || compression_ == rle_4 ? read_packed(data) : read_plain(data);
    }

private:
    static constexpr std::uint32_t file_header_size = 14;
    static constexpr std::uint32_t core_size = 12;
    static constexpr std::uint32_t info_size = 40;
    static constexpr std::uint32_t size_with_alpha_mask = 56;

    enum Compression : std::uint32_t { none = 0, rle_8 = 1, rle_4 = 2, bit_fields = 3, alpha_bit_fields = 6 };
    using Colour = Bitmap::Colour;

    void read_core_header(ByteReader& file)
    {
        width_ = file.little_endian_16();
        height_ = file.little_endian_16();
        file.skip(2); // planes
        bits_ = file.little_endian_16();
    }

    void read_info_header(ByteReader& file, std::uint32_t header_size)
    {
        width_ = file.little_endian_32();
        height_ = file.little_endian_32();
        is_from_top_ = height_ > 0x7fffffffu; // negative
        if (is_from_top_)
            height_ = 0u - height_;
        file.skip(2); // planes
        bits_ = file.little_endian_16();
        compression_ = file.little_endian_32();
        file.skip(12); // size in bytes, pixels per metre
        colours_used_ = file.little_endian_32();
        file.skip(4); // important colours
        if (bits_ == 16)
            masks_ = {0x7c00, 0x3e0, 0x1f};
        // The masks follow the first 40 bytes, which are the whole header or the beginning of that of a later version.
        if (compression_ == bit_fields || compression_ == alpha_bit_fields) {
            for (std::uint32_t& mask : masks_)
                mask = file.little_endian_32();
            if (compression_ == alpha_bit_fields || header_size >= size_with_alpha_mask)
                alpha_mask_ = file.little_endian_32();
        }
    }

    void require_supported() const
    {
        if (width_ == 0 || width_ > 0x7fffffffu || height_ == 0)
            throw ImageError("has no pixels");
        constexpr std::array<unsigned, 6> known = {1, 4, 8, 16, 24, 32};
        if (std::find(known.begin(), known.end(), bits_) == known.end())
            throw ImageError(std::to_string(bits_) + " bits per pixel are not supported");
        const bool has_masks = compression_ == bit_fields || compression_ == alpha_bit_fields;
        const bool fits = compression_ == none || (compression_ == rle_8 && bits_ == 8) ||
                          (compression_ == rle_4 && bits_ == 4) || (has_masks && (bits_ == 16 || bits_ == 32));
        if (!fits)
            throw ImageError("uses a compression method that is not supported");
    }

    /// Reads the palette, which ends where the pixels begin even if the header claims more colours.
    void read_palette(std::uint32_t header_size, std::uint32_t pixel_offset)
    {
        ByteReader file(bytes_);
        file.skip(file_header_size);
        file.skip(header_size);
        const std::uint64_t begin = std::uint64_t{file_header_size} + header_size;
        const std::uint32_t entry_bytes = header_size == core_size ? 3 : 4;
        const std::uint64_t room = pixel_offset > begin ? (pixel_offset - begin) / entry_bytes : 0;
        const std::uint64_t most = std::uint64_t{1} << bits_;
        const std::uint64_t claimed = colours_used_ == 0 ? most : colours_used_;
        const std::uint64_t count = std::min({claimed, most, room});
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint8_t* const entry = file.bytes(entry_bytes);
            palette_[i] = {entry[2], entry[1], entry[0]};
        }
    }

    /// The row of the image that is row `j` of the file.
    std::uint32_t row_at(std::uint32_t j) const { return is_from_top_ ? j : height_ - 1 - j; }

    Bitmap read_plain(ByteReader& data) const
    {
        const std::uint64_t row_bits = std::uint64_t{width_} * bits_;
        const std::uint64_t row_bytes = (row_bits + 7) / 8;
        const std::uint64_t stride = (row_bits + 31) / 32 * 4;
        const std::uint64_t padding = stride - row_bytes; // may be missing after the last row
        if ((data.left() + padding) / stride < height_)
            throw ImageError("ends too early");
        Bitmap bitmap = blank_bitmap(width_, height_, alpha_mask_ != 0);
        for (std::uint32_t j = 0; j < height_; ++j) {
            const std::uint8_t* const row = data.bytes(static_cast<std::size_t>(row_bytes));
            data.skip(std::min(static_cast<std::size_t>(padding), data.left()));
            for (std::uint32_t i = 0; i < width_; ++i)
                bitmap.set(i, row_at(j), colour_of(row, i), masked(word_of(row, i), alpha_mask_));
        }
        drop_unused_alpha(bitmap);
        return bitmap;
    }

    /// The bits of a pixel of 16 or 32.
    std::uint32_t word_of(const std::uint8_t* row, std::size_t i) const
    {
        std::uint32_t word = 0;
        const std::size_t bytes = bits_ / 8;
        for (std::size_t byte = 0; byte < bytes; ++byte)
            word |= std::uint32_t{row[bytes * i + byte]} << 8 * byte;
        return word;
    }

    Colour colour_of(const std::uint8_t* row, std::size_t i) const
    {
        if (bits_ == 24)
            return {row[3 * i + 2], row[3 * i + 1], row[3 * i]};
        if (bits_ <= 8)
            return palette_[packed_number(row, i, bits_)];
        const std::uint32_t word = word_of(row, i);
        return {masked(word, masks_[0]), masked(word, masks_[1]), masked(word, masks_[2])};
    }

    static std::uint8_t masked(std::uint32_t word, std::uint32_t mask)
    {
        if (mask == 0)
            return 0;
        const std::uint32_t lowest = mask & (0u - mask);
        const std::uint64_t largest = mask / lowest;
        return static_cast<std::uint8_t>(((word & mask) / lowest * std::uint64_t{255} + largest / 2) / largest);
    }

    /// Reads run-length encoded pixels. A code has two bytes: the length of a run and its pixels, or 0 and an escape:
    /// end of the row (0), end of the image (1), a step to the right and to later rows (2), or a number of single
    /// pixels. Pixels that are skipped get colour 0; pixels outside the image are ignored.
    Bitmap read_packed(ByteReader& data) const
    {
        // A run has at most 255 pixels. This also refuses images that skip nearly all pixels, which nobody writes.
        if (std::uint64_t{width_} * height_ / 255 > data.left())
            throw ImageError("ends too early");
        Bitmap bitmap = blank_bitmap(width_, height_);
        for (std::uint32_t pixel = 0; pixel < width_ * height_; ++pixel)
            bitmap.set(pixel % width_, pixel / width_, palette_[0]);
        std::uint64_t x = 0;
        std::uint64_t y = 0;
        const auto paint = [&](unsigned index) {
            if (x < width_ && y < height_)
                bitmap.set(static_cast<std::uint32_t>(x), row_at(static_cast<std::uint32_t>(y)), palette_[index]);
            ++x;
        };
        for (;;) {
            const std::size_t run = data.byte();
            const std::uint8_t value = data.byte();
            if (run > 0) {
                for (std::size_t i = 0; i < run; ++i)
                    paint(packed_number(&value, bits_ == 8 ? 0 : i % 2, bits_));
            } else if (value == 0) {
                x = 0;
                ++y;
            } else if (value == 1) {
                return bitmap;
            } else if (value == 2) {
                x += data.byte();
                y += data.byte();
            } else {
                const std::size_t count = bits_ == 8 ? value : (value + 1u) / 2u;
                const std::uint8_t* const packed = data.bytes(count);
                for (std::size_t i = 0; i < value; ++i)
                    paint(packed_number(packed, i, bits_));
                data.skip(count % 2);
            }
        }
    }

    std::string_view bytes_;
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    bool is_from_top_ = false;
    unsigned bits_ = 0; ///< of a pixel
    std::uint32_t compression_ = none;
    std::uint32_t colours_used_ = 0; ///< 0 for all
    std::array<std::uint32_t, 3> masks_ = {0xff0000, 0xff00, 0xff};
    std::uint32_t alpha_mask_ = 0;         ///< 0: no opacity; without masks the fourth byte of a pixel has no meaning
    std::array<Colour, 256> palette_ = {}; ///< black after its end
};

} // namespace

Bitmap read_bmp(std::string_view bytes)
{
    return BmpReader(bytes).read();
}

} // namespace multipath
