// Reader of PNG files (ISO/IEC 15948). A file is a list of chunks: a header, perhaps a palette, and a zlib stream of
// filtered rows. The checksums of chunks are ignored: damaged pixels show in the Adler-32 checksum of the stream, and a
// wrong checksum elsewhere is no reason to refuse a texture.

#include "base/errors.h"
#include "scene/texture/byte_reader.h"
#include "scene/texture/image_formats.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace multipath {

namespace {

class PngReader
{
public:
    explicit PngReader(std::string_view bytes) : file_(bytes) {}

    Bitmap read()
    {
        file_.skip(8); // signature
        Chunk chunk = next_chunk();
        if (chunk.type != "IHDR")
            throw ImageError("does not begin with a header");
        read_header(chunk.data);
        std::string stream;
        for (chunk = next_chunk(); chunk.type != "IEND"; chunk = next_chunk()) {
            if (chunk.type == "IDAT")
                stream += chunk.data;
            else if (chunk.type == "PLTE")
                read_palette(chunk.data);
            else if (chunk.type == "tRNS")
                transparency_ = chunk.data;
            else if (const bool is_critical = (chunk.type[0] & 0x20) == 0; is_critical)
                throw ImageError("has a chunk of an unknown type");
        }
        if (colour_type_ == indexed && !has_palette_)
            throw ImageError("has no palette");
        return read_pixels(stream);
    }

private:
    enum ColourType : unsigned { grey = 0, rgb = 2, indexed = 3, grey_alpha = 4, rgb_alpha = 6 };

    struct Chunk
    {
        std::string_view type;
        std::string_view data;
    };

    /// A pass of an interlaced image (Adam7): the pixels (x + i dx, y + j dy), stored like an image of their own.
    struct Pass
    {
        std::uint32_t x, y, dx, dy;

        std::uint32_t columns(std::uint32_t width) const { return (width + dx - 1 - x) / dx; }
        std::uint32_t rows(std::uint32_t height) const { return (height + dy - 1 - y) / dy; }
    };

    Chunk next_chunk()
    {
        const std::uint32_t size = file_.big_endian_32();
        const auto* const type = reinterpret_cast<const char*>(file_.bytes(4));
        const auto* const data = reinterpret_cast<const char*>(file_.bytes(size));
        file_.skip(4); // checksum
        return {{type, 4}, {data, size}};
    }

    void read_header(std::string_view data)
    {
        ByteReader header(data);
        width_ = header.big_endian_32();
        height_ = header.big_endian_32();
        depth_ = header.byte();
        colour_type_ = header.byte();
        const std::uint8_t compression = header.byte();
        const std::uint8_t filter = header.byte();
        const std::uint8_t interlace = header.byte();
        constexpr std::array<unsigned, 7> samples_of_type = {1, 0, 3, 1, 2, 0, 4};
        samples_ = colour_type_ < samples_of_type.size() ? samples_of_type[colour_type_] : 0;
        const bool is_power_of_two = depth_ != 0 && (depth_ & (depth_ - 1)) == 0;
        const unsigned least = colour_type_ == grey || colour_type_ == indexed ? 1 : 8;
        const unsigned most = colour_type_ == indexed ? 8 : 16;
        if (samples_ == 0 || !is_power_of_two || depth_ < least || depth_ > most)
            throw ImageError("has an unknown pixel format");
        if (compression != 0 || filter != 0 || interlace > 1)
            throw ImageError("uses an unknown compression method");
        is_interlaced_ = interlace == 1;
        require_bitmap_size(width_, height_);
    }

    void read_palette(std::string_view data)
    {
        if (data.size() > 3 * palette_.size() || data.size() % 3 != 0)
            throw ImageError("has a damaged palette");
        for (std::size_t k = 0; k < data.size(); ++k)
            palette_[k / 3][k % 3] = static_cast<std::uint8_t>(data[k]);
        has_palette_ = true;
    }

    std::vector<Pass> passes() const
    {
        if (!is_interlaced_)
            return {{0, 0, 1, 1}};
        return {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    }

    std::size_t row_bytes(std::uint32_t columns) const { return (std::size_t{columns} * samples_ * depth_ + 7) / 8; }

    Bitmap read_pixels(std::string_view stream) const
    {
        std::size_t size = 0;
        for (const Pass& pass : passes())
            if (const std::uint32_t columns = pass.columns(width_); columns > 0)
                size += pass.rows(height_) * (1 + row_bytes(columns));
        std::vector<std::uint8_t> data = inflate(stream, size);
        Bitmap bitmap = blank_bitmap(width_, height_, has_alpha_channel() || !transparency_.empty());
        std::uint8_t* next = data.data();
        for (const Pass& pass : passes())
            if (pass.columns(width_) > 0)
                next = read_pass(pass, next, bitmap);
        return bitmap;
    }

    /// Removes the filters of the rows of a pass, copies the rows into the bitmap and returns the end of their data.
    std::uint8_t* read_pass(const Pass& pass, std::uint8_t* next, Bitmap& bitmap) const
    {
        const std::uint32_t columns = pass.columns(width_);
        const std::size_t size = row_bytes(columns);
        const std::vector<std::uint8_t> zeros(size);
        const std::uint8_t* above = zeros.data();
        for (std::uint32_t j = 0; j < pass.rows(height_); ++j) {
            std::uint8_t* const row = next + 1;
            remove_filter(*next, row, above, size);
            above = row;
            next = row + size;
            paint(row, pass, pass.y + j * pass.dy, bitmap);
        }
        return next;
    }

    /// Adds to every byte its prediction from the bytes to the left and above, which are 0 outside the image (ISO/IEC
    /// 15948, 9.2).
    void remove_filter(unsigned filter, std::uint8_t* row, const std::uint8_t* above, std::size_t size) const
    {
        const std::size_t left = std::max(1u, samples_ * depth_ / 8); // distance to the same byte of the previous pixel
        const auto add = [&](const auto& prediction) {
            for (std::size_t i = 0; i < size; ++i) {
                const bool is_first = i < left;
                const int value = prediction(is_first ? 0 : row[i - left], above[i], is_first ? 0 : above[i - left]);
                row[i] = static_cast<std::uint8_t>(row[i] + value);
            }
        };
        switch (filter) {
        case 0:
            break;
        case 1:
            return add([](int before, int, int) { return before; });
        case 2:
            return add([](int, int over, int) { return over; });
        case 3:
            return add([](int before, int over, int) { return (before + over) / 2; });
        case 4:
            return add(paeth);
        default:
            throw ImageError("has damaged pixel data");
        }
    }

    /// The Paeth predictor: that of left, above and corner that is nearest to left + above - corner.
    static int paeth(int left, int above, int corner)
    {
        const int to_left = std::abs(above - corner);
        const int to_above = std::abs(left - corner);
        const int to_corner = std::abs(left + above - 2 * corner);
        const int vertical = to_above <= to_corner ? above : corner;
        return to_left <= to_above && to_left <= to_corner ? left : vertical;
    }

    bool has_alpha_channel() const { return colour_type_ == grey_alpha || colour_type_ == rgb_alpha; }

    /// Sets the pixels of a row of a pass. Of samples of 16 bits the high byte counts. The opacity is the last sample,
    /// or that of the colour in the palette, or 0 for the one colour that the file declares transparent, with samples
    /// of two bytes (ISO/IEC 15948, 11.3.2).
    void paint(const std::uint8_t* row, const Pass& pass, std::uint32_t y, Bitmap& bitmap) const
    {
        const bool is_grey = colour_type_ == grey || colour_type_ == grey_alpha;
        const unsigned white = is_grey && depth_ < 8 ? 255 / ((1u << depth_) - 1) : 1;
        const bool has_transparent_colour = transparency_.size() >= std::size_t{2} * samples_;
        const auto transparency_at = [&](std::size_t k) {
            return unsigned{static_cast<std::uint8_t>(transparency_[k])};
        };
        std::array<std::uint8_t, 4> levels = {};
        for (std::uint32_t i = 0; i < pass.columns(width_); ++i) {
            bool is_transparent = has_transparent_colour;
            for (std::size_t c = 0; c < samples_; ++c) {
                const std::size_t k = std::size_t{i} * samples_ + c;
                const unsigned sample =
                    depth_ == 16 ? unsigned{row[2 * k]} << 8 | row[2 * k + 1] : packed_number(row, k, depth_);
                is_transparent = is_transparent && sample == (transparency_at(2 * c) << 8 | transparency_at(2 * c + 1));
                levels[c] = static_cast<std::uint8_t>(depth_ == 16 ? sample >> 8 : sample * white);
            }
            const std::uint32_t x = pass.x + i * pass.dx;
            if (colour_type_ == indexed)
                bitmap.set(x, y, palette_[levels[0]],
                           levels[0] < transparency_.size() ? transparency_at(levels[0]) : 255);
            else
                bitmap.set(x, y, {levels[0], levels[is_grey ? 0 : 1], levels[is_grey ? 0 : 2]},
                           has_alpha_channel() ? levels[samples_ - 1]
                           : is_transparent    ? 0
                                               : 255);
        }
    }

    ByteReader file_;
    std::string_view transparency_; ///< contents of tRNS
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    unsigned depth_ = 0; ///< bits of a sample
    unsigned colour_type_ = 0;
    unsigned samples_ = 0; ///< of a pixel
    bool is_interlaced_ = false;
    bool has_palette_ = false;
    std::array<Bitmap::Colour, 256> palette_ = {}; ///< black after its end
};

} // namespace

Bitmap read_png(std::string_view bytes)
{
    return PngReader(bytes).read();
}

} // namespace multipath
