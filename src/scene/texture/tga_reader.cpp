// Reader of Truevision TGA files (TGA file format specification 2.0, 1991).

#include "base/errors.h"
#include "scene/texture/byte_reader.h"
#include "scene/texture/image_formats.h"

namespace multipath {

namespace {

class TgaReader
{
public:
    explicit TgaReader(std::string_view bytes) : file_(bytes) {}

    Bitmap read()
    {
        read_header();
        const std::uint64_t pixels = std::uint64_t{width_} * height_;
        constexpr std::uint64_t most_per_byte = 64; // a packet of at most 128 pixels has at least two bytes
        if (is_packed_ ? pixels > most_per_byte * file_.left() : pixels * pixel_bytes_ > file_.left())
            throw ImageError("ends too early");
        Bitmap bitmap = blank_bitmap(width_, height_, has_alpha_);
        for (std::uint32_t j = 0; j < height_; ++j)
            for (std::uint32_t i = 0; i < width_; ++i) {
                const std::uint8_t* const pixel = next_pixel();
                const Bitmap::Colour colour = {pixel[is_grey_ ? 0 : 2], pixel[is_grey_ ? 0 : 1], pixel[0]};
                bitmap.set(i, is_from_top_ ? j : height_ - 1 - j, colour, pixel[pixel_bytes_ - 1]);
            }
        drop_unused_alpha(bitmap);
        return bitmap;
    }

private:
    void read_header()
    {
        const std::size_t id_size = file_.byte();
        file_.skip(1); // whether there is a palette
        const unsigned type = file_.byte();
        file_.skip(2); // index of the first colour of the palette
        const std::size_t palette_size = file_.little_endian_16();
        const std::size_t palette_bits = file_.byte();
        file_.skip(4); // position on the screen
        width_ = file_.little_endian_16();
        height_ = file_.little_endian_16();
        const unsigned bits = file_.byte();
        const unsigned descriptor = file_.byte();
        constexpr unsigned rgb = 2;
        constexpr unsigned grey = 3;
        is_packed_ = (type & 8) != 0;
        is_grey_ = (type & ~8u) == grey;
        if ((type & ~8u) != rgb && !is_grey_)
            throw ImageError("is a TGA image of the unsupported type " + std::to_string(type));
        if (bits != (is_grey_ ? 8 : 24) && bits != (is_grey_ ? 16 : 32)) // without and with opacity
            throw ImageError(std::to_string(bits) + " bits per pixel are not supported");
        if ((descriptor & 0xd0) != 0)
            throw ImageError("has interleaved rows, or rows from the right, which are not supported");
        pixel_bytes_ = bits / 8;
        has_alpha_ = (descriptor & 15) == 8 && pixel_bytes_ % 2 == 0;
        is_from_top_ = (descriptor & 0x20) != 0;
        file_.skip(id_size + palette_size * ((palette_bits + 7) / 8));
    }

    /// The next pixel. A packet is a byte with the number of its pixels, followed by a single pixel that is repeated,
    /// or by all pixels. It may continue in the next row.
    const std::uint8_t* next_pixel()
    {
        if (!is_packed_)
            return file_.bytes(pixel_bytes_);
        const bool is_new = packet_left_ == 0;
        if (is_new) {
            const unsigned packet = file_.byte();
            packet_left_ = (packet & 0x7f) + 1;
            is_run_ = (packet & 0x80) != 0;
        }
        if (is_new || !is_run_)
            pixel_ = file_.bytes(pixel_bytes_);
        --packet_left_;
        return pixel_;
    }

    ByteReader file_;
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    bool is_grey_ = false;
    std::size_t pixel_bytes_ = 0;
    bool is_packed_ = false;
    bool has_alpha_ = false; ///< the last byte of a pixel is its opacity
    bool is_from_top_ = false;

    unsigned packet_left_ = 0; ///< pixels
    bool is_run_ = false;
    const std::uint8_t* pixel_ = nullptr;
};

} // namespace

Bitmap read_tga(std::string_view bytes)
{
    return TgaReader(bytes).read();
}

} // namespace multipath
