#pragma once

#include "scene/rgb.h"
#include "scene/texture/bitmap.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// A place of a texture: (0, 0) is its lower left corner, (1, 1) the upper right.
struct TexturePoint
{
    double s = 0.0;
    double t = 0.0;
};

/// An image as browsers and glTF take it.
struct ImageFile
{
    std::string type; ///< "image/png" or "image/jpeg"
    std::string bytes;
};

/// How a surface lies on a texture: its point (u, v) at origin + u along_u + v along_v.
struct TextureFrame
{
    TexturePoint origin;
    TexturePoint along_u;
    TexturePoint along_v;
    bool known = false; ///< otherwise the surface shows the mean of the texture

    TexturePoint at(double u, double v) const
    {
        return {origin.s + u * along_u.s + v * along_v.s, origin.t + u * along_u.t + v * along_v.t};
    }
};

/// A triangle or parallelogram of a texture.
struct TextureFootprint
{
    std::array<TexturePoint, 4> corners;
    std::size_t count = 4; ///< or 3
};

/// A picture as a colour that varies over a surface, in linear light [1]. Constant within each pixel, repeated in all
/// directions, or continued from its border.
class Texture
{
public:
    /// `bytes`: of an image file. Throws ImageError.
    Texture(std::string name, std::string bytes, bool repeats);

    const std::string& name() const { return name_; }
    const std::string& bytes() const { return bytes_; }
    bool repeats() const { return repeats_; }
    std::uint64_t hash() const { return hash_; } ///< of pixels and `repeats`
    const Bitmap& bitmap() const { return bitmap_; }

    Rgb mean() const { return mean_; }
    /// Exact, by Green's theorem, in time proportional to the pixels along the border. Of an area of 0 the middle.
    Rgb mean(const TextureFootprint& footprint) const;
    /// Between the middles of four pixels, bilinear.
    Rgb at(TexturePoint place) const;

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
    std::vector<std::uint32_t> sums_; ///< of the pixels of a row before every 16th, three colours each
    std::size_t sums_per_row_ = 0;
    Rgb mean_;
};

/// [1] Mean over the part of a surface between these points (u, v) of its square; of a triangle the first three count.
Rgb texture_mean(const Texture& texture, const TextureFrame& frame, std::size_t corners,
                 const std::array<std::array<double, 2>, 4>& uv);

/// [1] Linear light of a colour of 8 bits (IEC 61966-2-1, sRGB).
Rgb linear_colour(const std::uint8_t* rgb);

} // namespace multipath
