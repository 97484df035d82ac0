#include "scene/tessellation.h"

#include "geometry/intersector/surface_sizes.h"
#include "scene/input_error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace multipath {

namespace {

constexpr double cell_limit = 2147483648.0; // 2^31: patch numbers are 32 bits wide

/// Edges that are a multiple of the patch size but for rounding in the file must not get one cell more.
double cells_along(double edge, double patch_size)
{
    return std::max(1.0, std::ceil(edge / patch_size - 1e-6));
}

} // namespace

CellCorners Tessellation::corners(std::uint32_t cell) const
{
    if (shape == Shape::parallelogram) {
        const std::uint32_t i = cell / cells_v;
        const std::uint32_t j = cell % cells_v;
        return {{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}}, 4};
    }
    const double n = cells_u;
    auto i = static_cast<std::uint32_t>(n - std::sqrt(n * n - cell));
    while (i > 0 && cells_before_column(i, cells_u) > cell)
        --i;
    while (i + 1 < cells_u && cells_before_column(i + 1, cells_u) <= cell)
        ++i;
    const auto place = static_cast<std::uint32_t>(cell - cells_before_column(i, cells_u));
    const std::uint32_t j = place / 2;
    if (place % 2 == 0)
        return {{{{i, j}, {i + 1, j}, {i, j + 1}, {}}}, 3};
    return {{{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}, {}}}, 3};
}

Surface Tessellation::cell(const Surface& surface, std::uint32_t cell) const
{
    const double n_u = cells_u;
    const double n_v = cells_v;
    const CellCorners around = corners(cell);
    const GridPoint origin = around.points[0];
    const double along = around.points[1].i > origin.i ? 1.0 : -1.0; // every other cell of a triangle is upside down
    return {shape, surface.at(origin.i / n_u, origin.j / n_v), (along / n_u) * surface.edge_u,
            (along / n_v) * surface.edge_v};
}

namespace {

/// Real numbers, since a small patch size gives more cells than an integer holds.
struct CellCounts
{
    double along_u;
    double along_v;
};

CellCounts cell_counts(const Surface& surface, double patch_size)
{
    const double along_u = cells_along(length(surface.edge_u), patch_size);
    const double along_v = cells_along(length(surface.edge_v), patch_size);
    if (surface.shape == Shape::parallelogram)
        return {along_u, along_v};
    const double third_edge = cells_along(length(surface.edge_u - surface.edge_v), patch_size);
    const double most = std::max({along_u, along_v, third_edge});
    return {most, most};
}

} // namespace

Tessellation tessellate(const Surface& surface, double patch_size)
{
    const CellCounts cells = cell_counts(surface, patch_size);
    if (!(cells.along_u * cells.along_v < cell_limit))
        throw SettingsError("the patch size is too small: one surface alone would have 2^31 patches or more");
    return {surface.shape, static_cast<std::uint32_t>(cells.along_u), static_cast<std::uint32_t>(cells.along_v)};
}

double cell_count(const SurfaceList& surfaces, double patch_size)
{
    double sum = 0.0;
    for (const Surface& surface : surfaces) {
        const CellCounts cells = cell_counts(surface, patch_size);
        sum += cells.along_u * cells.along_v;
    }
    return sum;
}

namespace {

/// 1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten: number k of these sizes, 10 to a decade.
double round_size(int k)
{
    constexpr std::array<double, 10> mantissas = {1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    const int exponent = k >= 0 ? k / 10 : -((9 - k) / 10);
    const double mantissa = mantissas[static_cast<std::size_t>(k - 10 * exponent)];
    return exponent < 0 ? mantissa / std::pow(10.0, -exponent) : mantissa * std::pow(10.0, exponent);
}

double total_area(const SurfaceList& surfaces)
{
    double area = 0.0;
    for (const Surface& surface : surfaces)
        area += surface.area();
    return area;
}

/// Every surface has at least one.
bool has_more_cells(const SurfaceList& surfaces, double patch_size, std::uint64_t count)
{
    return surfaces.size() > count || cell_count(surfaces, patch_size) > static_cast<double>(count);
}

} // namespace

double default_patch_size(const SurfaceList& surfaces)
{
    const double wanted = std::sqrt(total_area(surfaces) / 2500.0);
    int k = 10 * static_cast<int>(std::floor(std::log10(wanted)));
    while (round_size(k + 1) <= wanted)
        ++k;
    // Long or many triangles give more cells than their area says.
    constexpr std::uint64_t most = 4000;
    while (round_size(k + 1) <= 3.0 * wanted && has_more_cells(surfaces, round_size(k), most))
        ++k;
    // Slivers by the thousand are left almost whole.
    const std::uint64_t bearable = (1u << 17) + 8 * surfaces.size();
    while (has_more_cells(surfaces, round_size(k), bearable))
        ++k;
    return round_size(k);
}

double patch_size_for_count(const SurfaceList& surfaces, std::uint64_t wanted)
{
    // The count falls with the size: bisection between squares of half the mean area, or less, and no cut at all.
    double too_small = 0.5 * std::sqrt(total_area(surfaces) / static_cast<double>(wanted));
    double enough = bounds_of(surfaces).diagonal();
    for (int step = 0; step < 50 && enough > too_small; ++step) {
        const double middle = 0.5 * (too_small + enough);
        (has_more_cells(surfaces, middle, wanted) ? too_small : enough) = middle;
    }
    return enough;
}

} // namespace multipath
