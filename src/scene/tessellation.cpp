// The cells of a parallelogram are numbered column by column: cell i * cells_v + j is j-th in column i along u. The
// lines u = i/n, v = j/n and u + v = k/n divide a triangle into n^2 similar triangles. Column i of them has 2 (n - i) -
// 1 cells, alternately the lower half of a grid square, with its origin at (i, j), and the upper half, which is upside
// down, with its origin at (i + 1, j + 1). Both kinds of cell divide into four similar ones, so one quadtree serves
// both shapes.

#include "scene/tessellation.h"

#include "base/elementary.h"
#include "base/errors.h"
#include "base/lists.h"
#include "geometry/intersector/surface_sizes.h"

#include <cmath>
#include <stdexcept>

namespace multipath {

namespace {

constexpr double cell_limit = 2147483648.0; // 2^31: patch numbers are 32 bits wide

/// Number of cells along an edge. An edge that is a multiple of the patch size, except for rounding in the file, must
/// not get an additional cell.
double cells_along(double edge, double patch_size)
{
    return std::max(1.0, std::ceil(edge / patch_size - 1e-6));
}

/// The four cells that a cell divides into. Those of a triangle lie at its origin, in its middle, at the end of its
/// edge_v and at the end of its edge_u.
std::array<GridCell, 4> parts_of(const GridCell& cell, Shape shape)
{
    const std::uint32_t a = 2 * cell.i;
    const std::uint32_t b = 2 * cell.j;
    if (shape == Shape::parallelogram)
        return {{{a, b}, {a, b + 1}, {a + 1, b}, {a + 1, b + 1}}};
    if (cell.upper)
        return {{{a + 1, b + 1, true}, {a + 1, b + 1, false}, {a + 1, b, true}, {a, b + 1, true}}};
    return {{{a, b, false}, {a, b, true}, {a, b + 1, false}, {a + 1, b, false}}};
}

[[noreturn]] void refuse_levels()
{
    throw std::invalid_argument("levels that are no quadtrees");
}

} // namespace

bool CellTrees::fit(const Tessellation& grid, std::uint8_t level)
{
    return level <= deepest && std::ldexp(static_cast<double>(grid.cell_count()), 2 * level) < cell_limit;
}

CellTrees::CellTrees(const Tessellation& grid, const std::uint8_t* levels, std::size_t count)
    : shape_(grid.shape), depth_(count > 0 ? *std::max_element(levels, levels + count) : std::uint8_t{0})
{
    if (!fit(grid, depth_))
        refuse_levels();
    const auto cells = static_cast<std::uint32_t>(grid.cell_count());
    nodes_.resize(cells);
    leaves_.reserve(count);
    for (std::uint32_t cell = 0; cell < cells; ++cell)
        add_tree(grid, grid.grid_cell(cell), 0, cell, levels, count);
    if (leaves_.size() != count)
        refuse_levels();
}

void CellTrees::add_tree(const Tessellation& grid, GridCell cell, std::uint8_t level, std::size_t node,
                         const std::uint8_t* levels, std::size_t count)
{
    const std::size_t leaf = leaves_.size();
    if (leaf >= count || levels[leaf] < level)
        refuse_levels();
    if (levels[leaf] == level) {
        nodes_[node] = static_cast<std::uint32_t>(leaf);
        leaves_.push_back({grid.uniform(level).number(cell), level});
        return;
    }
    std::size_t part = nodes_.size();
    nodes_[node] = inner | static_cast<std::uint32_t>(part);
    nodes_.resize(part + 4);
    for (const GridCell& quarter : parts_of(cell, shape_))
        add_tree(grid, quarter, static_cast<std::uint8_t>(level + 1), part++, levels, count);
}

GridCell Tessellation::grid_cell(std::uint32_t cell) const
{
    if (shape == Shape::parallelogram)
        return {cell / cells_v, cell % cells_v};
    const double n = cells_u;
    auto i = static_cast<std::uint32_t>(n - std::sqrt(n * n - cell));
    while (i > 0 && cells_before_column(i, cells_u) > cell)
        --i;
    while (i + 1 < cells_u && cells_before_column(i + 1, cells_u) <= cell)
        ++i;
    const auto in_column = static_cast<std::uint32_t>(cell - cells_before_column(i, cells_u));
    return {i, in_column / 2, in_column % 2 != 0};
}

std::uint32_t Tessellation::number(const GridCell& cell) const
{
    if (shape == Shape::parallelogram)
        return cell.i * cells_v + cell.j;
    return static_cast<std::uint32_t>(cells_before_column(cell.i, cells_u)) + 2 * cell.j + (cell.upper ? 1 : 0);
}

CellCorners Tessellation::corners(std::uint32_t cell) const
{
    const std::uint8_t level = this->level(cell);
    const auto [i, j, upper] = uniform(level).grid_cell(trees ? trees->cell_of_level(cell) : cell);
    CellCorners result = {{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}}, 4};
    if (shape == Shape::triangle && upper)
        result = {{{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}, {}}}, 3};
    else if (shape == Shape::triangle)
        result = {{{{i, j}, {i + 1, j}, {i, j + 1}, {}}}, 3};
    for (GridPoint& point : result.points) {
        point.i <<= depth() - level;
        point.j <<= depth() - level;
    }
    return result;
}

Surface Tessellation::cell(const Surface& surface, std::uint32_t cell) const
{
    if (trees)
        return uniform(trees->level(cell)).cell(surface, trees->cell_of_level(cell));
    const double n_u = cells_u;
    const double n_v = cells_v;
    const auto [i, j, upper] = grid_cell(cell);
    const std::uint32_t further = upper ? 1 : 0;
    const double along = upper ? -1.0 : 1.0; // every other cell of a triangle is upside down
    return {shape, surface.at((i + further) / n_u, (j + further) / n_v), (along / n_u) * surface.edge_u,
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
    return {surface.shape, static_cast<std::uint32_t>(cells.along_u), static_cast<std::uint32_t>(cells.along_v),
            nullptr};
}

double cell_count(const SurfaceList& surfaces, double patch_size)
{
    return sum_over(surfaces, [&](const Surface& surface) {
        const CellCounts cells = cell_counts(surface, patch_size);
        return cells.along_u * cells.along_v;
    });
}

namespace {

/// The k-th round number, ten to a decade: 1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten.
double round_size(int k)
{
    constexpr std::array<double, 10> mantissas = {1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    const int exponent = k >= 0 ? k / 10 : -((9 - k) / 10);
    const double mantissa = mantissas[static_cast<std::size_t>(k - 10 * exponent)];
    return exponent < 0 ? mantissa / elementary::pow(10.0, -exponent) : mantissa * elementary::pow(10.0, exponent);
}

/// True if this patch size gives more than `count` cells. Every surface has at least one.
bool has_more_cells(const SurfaceList& surfaces, double patch_size, std::uint64_t count)
{
    return surfaces.size() > count || cell_count(surfaces, patch_size) > static_cast<double>(count);
}

} // namespace

double default_patch_size(const SurfaceList& surfaces)
{
    const double wanted = std::sqrt(sum_over(surfaces, &Surface::area) / 2500.0);
    int k = 10 * static_cast<int>(std::floor(elementary::log10(wanted)));
    while (round_size(k + 1) <= wanted)
        ++k;
    // Long or numerous triangles give more cells than their area suggests.
    constexpr std::uint64_t most = 4000;
    while (round_size(k + 1) <= 3.0 * wanted && has_more_cells(surfaces, round_size(k), most))
        ++k;
    // Thousands of slivers are hardly divided at all.
    const std::uint64_t bearable = (1u << 17) + 8 * surfaces.size();
    while (has_more_cells(surfaces, round_size(k), bearable))
        ++k;
    return round_size(k);
}

double patch_size_for_count(const SurfaceList& surfaces, std::uint64_t wanted)
{
    // The count falls with the size: bisection between cells of a quarter of the mean area and no division at all.
    double too_small = 0.5 * std::sqrt(sum_over(surfaces, &Surface::area) / static_cast<double>(wanted));
    double enough = bounds_of(surfaces).diagonal();
    for (int step = 0; step < 50 && enough > too_small; ++step) {
        const double middle = 0.5 * (too_small + enough);
        (has_more_cells(surfaces, middle, wanted) ? too_small : enough) = middle;
    }
    return enough;
}

} // namespace multipath
