#pragma once

#include "scene/rgb.h"
#include "scene/tessellation.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// The corners of one surface's patches. Corner (i, j) lies at u = i / cells_u, v = j / cells_v; they are numbered row
/// by row with j, a triangle's rows getting shorter.
class CornerLattice
{
public:
    explicit CornerLattice(const Tessellation& tessellation);

    std::uint32_t last_column(std::uint32_t j) const { return triangle() ? cells_u_ - j : cells_u_; }
    std::uint32_t last_row() const { return cells_v_; }
    std::size_t number(std::uint32_t i, std::uint32_t j) const;
    std::size_t corner_count() const { return number(0, cells_v_) + last_column(cells_v_) + 1; }
    double u(std::uint32_t i) const { return static_cast<double>(i) / cells_u_; }
    double v(std::uint32_t j) const { return static_cast<double>(j) / cells_v_; }

    bool on_border(std::uint32_t i, std::uint32_t j) const { return cells_at(i, j) < (triangle() ? 6u : 4u); }
    /// How many patches meet at a corner.
    std::uint32_t cells_at(std::uint32_t i, std::uint32_t j) const;

    /// Values at all corners from one value per patch, which is asked for at a point (u, v) inside the patch.
    /// A parallelogram's border is extrapolated; a triangle's corners are means of the patches around them.
    std::vector<Rgb> corner_values(const std::function<Rgb(double u, double v)>& patch_value) const;

    /// Between the corners of the patch at (u, v): bilinear, or barycentric on a triangle. `values` is that of corner
    /// 0.
    Rgb interpolated(const Rgb* values, double u, double v) const;

private:
    bool triangle() const { return shape_ == Shape::triangle; }
    std::vector<Rgb> triangle_corners(const std::function<Rgb(double u, double v)>& patch_value) const;
    std::vector<Rgb> parallelogram_corners(const std::function<Rgb(double u, double v)>& patch_value) const;

    Shape shape_;
    std::uint32_t cells_u_;
    std::uint32_t cells_v_;
};

} // namespace multipath
