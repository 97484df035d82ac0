// Reader of Truevision TGA files (TGA file format specification 2.0, 1991).

#include "base/errors.h"
#include "scene/texture/byte_reader.h"
#include "scene/texture/image_formats.h"

#include <algorithm>
#include <array>

namespace multipath {

namespace {

class TgaReader
{
public:
    explicit TgaReader(std::string_view bytes) : file_(bytes) {}

    Bitmap read()
    {
        read_header();
        file_.skip(id_size_);
        read_colour_map();
        const std::uint64_t pixels = std::uint64_t{width_} * height_;
        constexpr std::uint64_t most_per_byte = 64; // a packet of at most 128 pixels has at least two bytes
        if (is_packed_ ? pixels > most_per_byte * file_.left() : pixels * pixel_bytes_ > file_.left())
            throw ImageError("ends too early");
        Bitmap bitmap = blank_bitmap(width_, height_, has_alpha_);
        for (std::uint32_t j = 0; j < height_; ++j) {
            for (std::uint32_t i = 0; i < width_; ++i) {
                const std::uint8_t* const pixel = next_pixel();
                bitmap.set(is_from_right_ ? width_ - 1 - i : i, is_from_top_ ? j : height_ - 1 - j, colour_of(pixel),
                           pixel[pixel_bytes_ - 1]);
            }
        }
        drop_unused_alpha(bitmap);
        return bitmap;
    }

private:
    using Colour = Bitmap::Colour;
    enum Kind : unsigned { indexed = 1, rgb = 2, grey = 3 };

    void read_header()
    {
        id_size_ = file_.byte();
        has_map_ = file_.byte() == 1;
        const unsigned type = file_.byte();
        map_first_ = file_.little_endian_16();
        map_size_ = file_.little_endian_16();
        map_bits_ = file_.byte();
        file_.skip(4); // position on the screen
        width_ = file_.little_endian_16();
        height_ = file_.little_endian_16();
        const unsigned bits = file_.byte();
        const unsigned descriptor = file_.byte();

        is_packed_ = (type & 8) != 0;
        kind_ = type & ~8u;
        if (kind_ < indexed || kind_ > grey)
            throw ImageError("is a TGA image of the unsupported type " + std::to_string(type));
        const bool is_known = kind_ == rgb ? is_colour_size(bits) : bits == 8 || bits == 16;
        if (!is_known)
            throw ImageError(std::to_string(bits) + " bits per pixel are not supported");
        pixel_bytes_ = (bits + 7) / 8;
        has_alpha_ = (descriptor & 15) == 8 && (kind_ == rgb ? bits == 32 : kind_ == grey && bits == 16);
        is_from_right_ = (descriptor & 0x10) != 0;
        is_from_top_ = (descriptor & 0x20) != 0;
        if ((descriptor & 0xc0) != 0)
            throw ImageError("has interleaved rows, which are not supported");
    }

    static bool is_colour_size(unsigned bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

    void read_colour_map()
    {
        if (!has_map_) {
            if (kind_ == indexed)
                throw ImageError("has no palette");
            return;
        }
        const std::size_t entry_bytes = (map_bits_ + 7u) / 8u;
        const std::uint8_t* const entries = file_.bytes(map_size_ * entry_bytes);
        if (kind_ != indexed)
            return;
        if (!is_colour_size(map_bits_))
            throw ImageError(std::to_string(map_bits_) + " bits per colour of the palette are not supported");
        map_.reserve(map_size_);
        for (std::size_t i = 0; i < map_size_; ++i)
            map_.push_back(colour_at(entries + i * entry_bytes, entry_bytes));
    }

    /// Pixels of 15 and 16 bits hold 5 bits of red, green and blue each, from high to low; bit 15 is ignored.
    static Colour colour_at(const std::uint8_t* bytes, std::size_t count)
    {
        if (count > 2)
            return {bytes[2], bytes[1], bytes[0]};
        const unsigned word = bytes[0] | unsigned{bytes[1]} << 8;
        const auto scaled = [](unsigned value) { return static_cast<std::uint8_t>(((value & 31) * 255 + 15) / 31); };
        return {scaled(word >> 10), scaled(word >> 5), scaled(word)};
    }

    Colour colour_of(const std::uint8_t* pixel) const
    {
        if (kind_ == rgb)
            return colour_at(pixel, pixel_bytes_);
        if (kind_ == grey) // a second byte is alpha
            return {pixel[0], pixel[0], pixel[0]};
        const std::size_t number = pixel_bytes_ == 1 ? pixel[0] : pixel[0] | std::size_t{pixel[1]} << 8;
        const std::size_t index = number - map_first_; // wraps to a large number below the first
        return index < map_.size() ? map_[index] : Colour{};
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
    std::size_t id_size_ = 0;
    bool has_map_ = false;
    std::size_t map_first_ = 0; ///< index of the first colour in the map
    std::size_t map_size_ = 0;
    unsigned map_bits_ = 0;
    std::vector<Colour> map_;
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    unsigned kind_ = 0;
    std::size_t pixel_bytes_ = 0;
    bool is_packed_ = false;
    bool has_alpha_ = false; ///< the last byte of a pixel is its opacity
    bool is_from_right_ = false;
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
