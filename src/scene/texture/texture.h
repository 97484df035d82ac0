#pragma once

#include "scene/rgb.h"
#include "scene/texture/bitmap.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// A point of a texture: (0, 0) is the lower left corner of the image, (1, 1) the upper right.
struct TexturePoint
{
    double s = 0.0;
    double t = 0.0;
};

/// An encoded image in a format of browsers and glTF.
struct ImageFile
{
    std::string type; ///< "image/png" or "image/jpeg"
    std::string bytes;
};

/// The affine map from a surface to a texture: (u, v) to origin + u along_u + v along_v.
struct TextureFrame
{
    TexturePoint origin;
    TexturePoint along_u;
    TexturePoint along_v;
    bool known = false; ///< false: the surface shows the mean of the texture

    TexturePoint at(double u, double v) const
    {
        return {origin.s + u * along_u.s + v * along_v.s, origin.t + u * along_u.t + v * along_v.t};
    }
};

/// A triangle or parallelogram in texture coordinates.
struct TextureFootprint
{
    std::array<TexturePoint, 4> corners;
    std::size_t count = 4; ///< or 3
};

/// An image as a colour in linear light [1] that varies over a surface. It is constant within each pixel (except in
/// at()); outside its square it repeats, or continues the pixels of its border.
class Texture
{
public:
    /// `bytes` is the contents of an image file. Throws ImageError.
    Texture(std::string name, std::string bytes, bool repeats);

    const std::string& name() const { return name_; }
    const std::string& bytes() const { return bytes_; }
    bool repeats() const { return repeats_; }
    std::uint64_t hash() const { return hash_; } ///< of the pixels and `repeats`
    const Bitmap& bitmap() const { return bitmap_; }

    Rgb mean() const { return mean_; }
    /// The mean over a polygon: exact, by Green's theorem, in time proportional to the pixels along its border. Without
    /// area it is the pixel at the middle; with a border of 10^6 pixels or more it is the mean of the whole texture.
    Rgb mean(const TextureFootprint& footprint) const;
    /// The colour at a point, by bilinear interpolation between the centres of four pixels.
    Rgb at(TexturePoint point) const;

private:
    using Sums = std::array<std::int64_t, 3>;

    std::int64_t column(std::int64_t x) const;
    std::uint32_t row(std::int64_t y) const;
    const std::uint8_t* pixel(std::int64_t x, std::int64_t y) const;
    Sums sums_before(std::int64_t x, std::uint32_t row) const;
    void integrate(TexturePoint from, TexturePoint to, std::int64_t first_column, std::array<double, 3>& sums) const;

    std::string name_;
    std::string bytes_;
    bool repeats_;
    Bitmap bitmap_;
    std::uint64_t hash_ = 0;
    std::vector<std::uint32_t> sums_; ///< of a row's pixels before every 16th one, three channels each
    std::size_t sums_per_row_ = 0;
    Rgb mean_;
};

/// [1] The mean of a texture over the polygon with these (u, v) corners on a surface; `corners`, 3 or 4, is their
/// number. With an unknown frame it is the mean of the whole texture.
Rgb texture_mean(const Texture& texture, const TextureFrame& frame, std::size_t corners,
                 const std::array<std::array<double, 2>, 4>& uv);

/// [1] Linear light of an 8-bit sRGB colour (IEC 61966-2-1).
Rgb linear_colour(const std::uint8_t* rgb);

} // namespace multipath
