#pragma once

#include "scene/rgb.h"
#include "scene/texture/image_formats.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// A point in texture coordinates: (0, 0) is the lower left corner of the image, (1, 1) the upper right one.
struct TexturePoint
{
    double s = 0.0;
    double t = 0.0;
};

/// An encoded image in a format that browsers and glTF accept.
struct ImageFile
{
    std::string type; ///< "image/png" or "image/jpeg"
    std::string bytes;
};

/// The affine map from a surface to a texture: the point (u, v) of the surface shows the point origin + u * along_u + v
/// * along_v of the texture.
struct TextureFrame
{
    TexturePoint origin;
    TexturePoint along_u;
    TexturePoint along_v;
    bool known = false; ///< false: no texture coordinates, so the surface has the mean colour of the texture

    /// The point of the texture at (u, v) of the surface.
    TexturePoint at(double u, double v) const
    {
        return {origin.s + u * along_u.s + v * along_v.s, origin.t + u * along_u.t + v * along_v.t};
    }
};

/// The corners of a convex polygon in the plane of a texture, in order around the border, in either direction.
using TexturePolygon = std::vector<TexturePoint>;

/// The area of a polygon, positive if its corners run counter-clockwise.
double area_of(const TexturePolygon& polygon);

/// The mean of the corners.
TexturePoint middle_of(const TexturePolygon& polygon);

/// A colour in linear light [1] that varies over a surface, given by an image. Outside the square between (0, 0) and
/// (1, 1) the image repeats, or the pixels of its border continue. For mean() the colour is constant within each pixel;
/// at() interpolates.
class Texture
{
public:
    /// Decodes an image file, whose contents are `bytes`; `name` is its file name. `repeats`: true if the image repeats
    /// outside its square. Throws ImageError like read_image().
    Texture(std::string name, std::string bytes, bool repeats);

    const std::string& name() const { return name_; }
    const std::string& bytes() const { return bytes_; }
    bool repeats() const { return repeats_; }
    std::uint64_t hash() const { return hash_; } ///< of the size, the pixels and `repeats`
    const Bitmap& bitmap() const { return bitmap_; }

    Rgb mean() const { return mean_; } ///< [1] over the whole image
    /// [1] The mean over a polygon: exact, by Green's theorem, in time proportional to the number of pixels along its
    /// border; upright edges count for no more than 16. For a polygon without area it is the pixel at the middle of the
    /// corners. For a border of 10^6 pixels or more, or 10^13 pixels away from an image that does not repeat, it is the
    /// mean of the whole image.
    Rgb mean(TexturePolygon polygon) const;
    /// [1] The colour at a point, interpolated bilinearly between the centres of four pixels.
    Rgb at(TexturePoint point) const;

private:
    using Sums = std::array<std::int64_t, 3>;

    /// Some neighbouring pixels of a row, and the sums of the linear light of all pixels before them in the row. What a
    /// step of integrate() reads lies together.
    struct Strip
    {
        static constexpr std::size_t width = 4; ///< pixels
        std::array<std::uint32_t, 3> before;
        std::array<std::uint8_t, 3 * width> rgb; ///< unset beyond the border of the image
    };

    std::int64_t column(std::int64_t x) const;
    std::uint32_t row(std::int64_t y) const;
    const std::uint8_t* pixel(std::int64_t x, std::int64_t y) const;
    Sums sums_within(std::int64_t end, std::uint32_t row) const;
    template <class SumsBefore>
    Sums continued(std::int64_t at, std::int64_t size, const SumsBefore& sums_before) const;
    Sums sums_before(std::int64_t x, std::uint32_t row) const;
    Sums sums_of_corner(std::int64_t x, std::int64_t y) const;
    Sums sums_below(std::int64_t x, std::int64_t y) const;
    Sums light(std::int64_t x, std::uint32_t row) const;
    void add_up_columns();
    void integrate(TexturePoint from, TexturePoint to, std::int64_t first_column, std::array<double, 3>& sums) const;
    void integrate_upright(double s, double from_t, double to_t, std::int64_t first_column,
                           std::array<double, 3>& sums) const;
    void integrate_slanted(TexturePoint from, TexturePoint to, std::int64_t first_column,
                           std::array<double, 3>& sums) const;

    std::string name_;
    std::string bytes_;
    bool repeats_;
    Bitmap bitmap_;
    std::uint64_t hash_ = 0;
    /// The strips of all rows, from the top, one below the other: edges of patches cross many rows.
    std::vector<Strip> strips_;
    static constexpr std::int64_t rows_per_block = 8;
    /// Sums of all pixels below and to the left of column x = 0 ... width and row y = 0, 8, 16, ... from below, column
    /// by column.
    std::vector<Sums> below_;
    Rgb mean_;
};

/// [1] The mean of a texture over a polygon on a surface. `uv` holds the (u, v) coordinates of the corners in order
/// around the polygon. With an unknown frame it is the mean of the whole image.
Rgb texture_mean(const Texture& texture, const TextureFrame& frame, const std::vector<std::array<double, 2>>& uv);

/// [1] Linear light of an 8-bit sRGB colour (IEC 61966-2-1), rounded to multiples of 1/65535. `rgb` points to three
/// bytes.
Rgb linear_colour(const std::uint8_t* rgb);

} // namespace multipath
