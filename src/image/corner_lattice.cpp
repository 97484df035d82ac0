#include "image/corner_lattice.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// The value one step outside a border, given the values inward from it. Continues the smaller of the two slopes, and
/// none where they disagree in sign: exact for a ramp, without overshoot at a shadow's edge or in noise.
double extrapolated(double border, double second, double third)
{
    const double near = border - second;
    const double far = second - third;
    if (near * far <= 0.0)
        return border;
    return border + (std::abs(near) < std::abs(far) ? near : far);
}

Rgb extrapolated(Rgb border, Rgb second, Rgb third)
{
    return {extrapolated(border.r, second.r, third.r), extrapolated(border.g, second.g, third.g),
            extrapolated(border.b, second.b, third.b)};
}

/// Fills the first and last of `count` values, `stride` apart, from those between them.
void extend(Rgb* values, std::size_t count, std::size_t stride)
{
    const auto at = [&](std::size_t n) -> Rgb& { return values[n * stride]; };
    const std::size_t inner = count - 2;
    if (inner == 1) {
        at(0) = at(2) = at(1);
        return;
    }
    // Two patches have one slope, which is all there is to continue.
    at(0) = extrapolated(at(1), at(2), inner == 2 ? at(2) - (at(1) - at(2)) : at(3));
    at(count - 1) = extrapolated(at(inner), at(inner - 1), inner == 2 ? at(1) - (at(2) - at(1)) : at(inner - 2));
}

Rgb not_negative(Rgb a)
{
    return {std::max(0.0, a.r), std::max(0.0, a.g), std::max(0.0, a.b)};
}

Rgb blend(double share, Rgb a, Rgb b)
{
    return (1.0 - share) * a + share * b;
}

/// The cell that a coordinate in [0, cells] falls into; the far border belongs to the last cell.
std::uint32_t cell_of(double scaled, std::uint32_t cells)
{
    return static_cast<std::uint32_t>(std::clamp(scaled, 0.0, cells - 1.0));
}

} // namespace

CornerLattice::CornerLattice(const Tessellation& tessellation)
    : shape_(tessellation.shape), cells_u_(tessellation.cells_u), cells_v_(tessellation.cells_v)
{
}

std::size_t CornerLattice::number(std::uint32_t i, std::uint32_t j) const
{
    const std::size_t full_rows = std::size_t{j} * (std::size_t{cells_u_} + 1);
    const std::size_t missing = triangle() && j > 0 ? std::size_t{j} * (j - 1) / 2 : 0;
    return full_rows - missing + i;
}

std::uint32_t CornerLattice::cells_at(std::uint32_t i, std::uint32_t j) const
{
    if (!triangle())
        return (i > 0 && i < cells_u_ ? 2u : 1u) * (j > 0 && j < cells_v_ ? 2u : 1u);
    const int sides_touched = (i == 0 ? 1 : 0) + (j == 0 ? 1 : 0) + (i + j == cells_u_ ? 1 : 0);
    return sides_touched == 0 ? 6 : sides_touched == 1 ? 3 : 1;
}

std::vector<Rgb> CornerLattice::corner_values(const std::function<Rgb(double u, double v)>& patch_value) const
{
    return triangle() ? triangle_corners(patch_value) : parallelogram_corners(patch_value);
}

std::vector<Rgb> CornerLattice::triangle_corners(const std::function<Rgb(double u, double v)>& patch_value) const
{
    std::vector<Rgb> corners(corner_count());
    const auto add = [&](std::uint32_t i, std::uint32_t j, Rgb value) {
        corners[number(i, j)] += 1.0 / cells_at(i, j) * value;
    };
    for (std::uint32_t j = 0; j < cells_u_; ++j) {
        for (std::uint32_t i = 0; i + j < cells_u_; ++i) {
            const Rgb upright = patch_value((i + 1.0 / 3.0) / cells_u_, (j + 1.0 / 3.0) / cells_u_);
            add(i, j, upright);
            add(i + 1, j, upright);
            add(i, j + 1, upright);
            if (i + j + 1 == cells_u_)
                continue; // at the slanted side there is no upside-down patch
            const Rgb upside_down = patch_value((i + 2.0 / 3.0) / cells_u_, (j + 2.0 / 3.0) / cells_u_);
            add(i + 1, j, upside_down);
            add(i, j + 1, upside_down);
            add(i + 1, j + 1, upside_down);
        }
    }
    return corners;
}

std::vector<Rgb> CornerLattice::parallelogram_corners(const std::function<Rgb(double u, double v)>& patch_value) const
{
    // The patches with a ring of extrapolated ones around them, so that every corner is the mean of four.
    const std::size_t width = std::size_t{cells_u_} + 2;
    const std::size_t height = std::size_t{cells_v_} + 2;
    std::vector<Rgb> ringed(width * height);
    for (std::size_t j = 1; j + 1 < height; ++j) {
        for (std::size_t i = 1; i + 1 < width; ++i)
            ringed[j * width + i] =
                patch_value((static_cast<double>(i) - 0.5) / cells_u_, (static_cast<double>(j) - 0.5) / cells_v_);
        extend(&ringed[j * width], width, 1);
    }
    for (std::size_t i = 0; i < width; ++i)
        extend(&ringed[i], height, width);

    std::vector<Rgb> corners;
    corners.reserve(corner_count());
    for (std::size_t j = 0; j + 1 < height; ++j)
        for (std::size_t i = 0; i + 1 < width; ++i) {
            const Rgb* here = &ringed[j * width + i];
            corners.push_back(not_negative(0.25 * (here[0] + here[1] + here[width] + here[width + 1])));
        }
    return corners;
}

Rgb CornerLattice::interpolated(const Rgb* values, double u, double v) const
{
    const double x = u * cells_u_;
    const double y = v * cells_v_;
    const std::uint32_t j = cell_of(y, cells_v_);
    const std::uint32_t i = cell_of(x, triangle() ? cells_u_ - j : cells_u_);
    const double right = std::clamp(x - i, 0.0, 1.0);
    const double up = std::clamp(y - j, 0.0, 1.0);
    const Rgb* lower = values + number(i, j);
    const Rgb* upper = values + number(i, j + 1);
    if (!triangle())
        return blend(up, blend(right, lower[0], lower[1]), blend(right, upper[0], upper[1]));
    if (right + up <= 1.0 || i + j + 1 == cells_u_)
        return (1.0 - right - up) * lower[0] + right * lower[1] + up * upper[0];
    return (right + up - 1.0) * upper[1] + (1.0 - right) * upper[0] + (1.0 - up) * lower[1];
}

} // namespace multipath
