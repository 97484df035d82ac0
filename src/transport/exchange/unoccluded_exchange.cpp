#include "transport/exchange/unoccluded_exchange.h"

#include "geometry/form_factor/exchange_area.h"
#include "geometry/intersector/intersector.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/polygon.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace multipath {

namespace {

/// True if a point of the plane of the shape lies inside it, clear of its border.
bool contains(const Surface& shape, Vec3 point)
{
    constexpr double inset = 1e-4; // share of an edge
    const Vec3 normal = cross(shape.edge_u, shape.edge_v);
    const Vec3 from_origin = point - shape.origin;
    const double scale = 1.0 / dot(normal, normal);
    const double u = scale * dot(cross(from_origin, shape.edge_v), normal);
    const double v = scale * dot(cross(shape.edge_u, from_origin), normal);
    const double farthest = shape.shape == Shape::triangle ? u + v : std::max(u, v);
    return std::min(u, v) > inset && farthest < 1.0 - inset;
}

/// The points of a grid x grid pattern on the first shape that are inside both shapes.
std::vector<Vec3> common_points(const Surface& small, const Surface& large, int grid)
{
    std::vector<Vec3> points;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const Vec3 point = small.at((i + 0.5) / grid, (j + 0.5) / grid);
            if (contains(large, point) && contains(small, point))
                points.push_back(point);
        }
    return points;
}

} // namespace

double share_in_contact(const Scene& scene, std::uint32_t a, std::uint32_t b)
{
    const bool a_is_small = scene.area(a) <= scene.area(b);
    const std::uint32_t from = a_is_small ? a : b;
    const std::uint32_t to = a_is_small ? b : a;
    const Patch start = scene.patch(from);
    const Surface end = scene.patch(to).shape;
    const double touching = coplanar_distance * scene.bounds().diagonal();
    const auto faces_other = [&](Vec3 point) {
        const Line line = {point, start.shape.normal()};
        std::uint32_t surface = start.surface;
        constexpr int most_faces = 64;
        for (int passed = 0; passed < most_faces; ++passed) { // faces of other solids in the same place
            const std::optional<Hit> hit = scene.intersector().closest_hit_from(surface, line);
            if (!hit || hit->t > touching)
                return false;
            if (hit->surface == scene.surface_of(to))
                return scene.patch_at(hit->surface, hit->u, hit->v, hit->front) == to;
            surface = hit->surface;
        }
        return false;
    };
    constexpr int coarsest = 4;
    double share = 0.0;
    for (const int grid : {coarsest, 32, 128}) { // the finest for slivers
        const std::vector<Vec3> points = common_points(start.shape, end, grid);
        if (points.empty())
            continue;
        const auto facing = std::count_if(points.begin(), points.end(), faces_other);
        share = static_cast<double>(facing) / static_cast<double>(points.size());
        if (share == 0.0 || share == 1.0 || grid > coarsest)
            break;
    }
    return share;
}

// Translation invariance saves most of the work. Surfaces are cut into grids of equal cells. If the grids of two
// surfaces have a step in common (a wall and the floor along their common edge, floor and ceiling in both directions),
// the exchange of two cells depends only on the difference of their indices along it (a Toeplitz matrix). Every pair of
// cells gets a slot, the sum of one number for each of the two cells. Pairs that differ by a translation share a slot,
// and only the first of them is computed.

namespace {

/// The patches on one side of a surface.
struct Side
{
    std::uint32_t surface;
    std::uint32_t first_patch;
    FlatPiece whole; ///< of the surface, with this side as its front
    FlatPolygon outline;
};

std::vector<Side> sides_of(const Scene& scene)
{
    std::vector<Side> sides;
    for (int back = 0; back < (scene.two_sided() ? 2 : 1); ++back)
        for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s) {
            Surface shape = scene.surfaces()[s];
            if (back > 0)
                std::swap(shape.edge_u, shape.edge_v);
            sides.push_back({s, scene.first_patch(s, back == 0), shape, polygon_of(shape)});
        }
    return sides;
}

/// True if one of the sides lies in the plane of the other, within `touching` [scene units].
bool in_one_plane(const Side& a, const Side& b, double touching)
{
    return heights(a.outline, b.whole.centre, b.whole.normal).within(touching) ||
           heights(b.outline, a.whole.centre, a.whole.normal).within(touching);
}

/// True if the sides may see each other: each has a point in front of the plane of the other, or they lie in one plane.
bool may_exchange(const Side& a, const Side& b, double touching)
{
    return a.surface != b.surface &&
           (in_one_plane(a, b, touching) || (heights(a.outline, b.whole.centre, b.whole.normal).high > touching &&
                                             heights(b.outline, a.whole.centre, a.whole.normal).high > touching));
}

/// One direction of a surface's grid.
struct GridAxis
{
    Vec3 step; ///< from a cell to the next one
    std::uint32_t cells;
};

/// The two axes of a surface's grid; cell (i, j) has number i * axes[1].cells + j. The cells of a triangle have two
/// orientations and no common step; all of them count as one axis with the step 0.
std::array<GridAxis, 2> grid_of(const Scene& scene, std::uint32_t surface)
{
    const Surface& s = scene.surfaces()[surface];
    const Tessellation& t = scene.tessellation(surface);
    if (s.shape == Shape::triangle)
        return {{{{}, static_cast<std::uint32_t>(t.cell_count())}, {{}, 1}}};
    return {{{(1.0 / t.cells_u) * s.edge_u, t.cells_u}, {(1.0 / t.cells_v) * s.edge_v, t.cells_v}}};
}

bool almost_equal(Vec3 a, Vec3 b)
{
    constexpr double rounding = 1e-10;
    const Vec3 d = a - b;
    return dot(d, d) < rounding * rounding * dot(a, a);
}

/// Slots of the pairs of cells of two grids: the sum of a number of the cell of a and one of the cell of b.
struct PairSlots
{
    std::array<std::ptrdiff_t, 2> a{}; ///< per axis of grid a: change per step; if negative, counted from the last cell
    std::array<std::ptrdiff_t, 2> b{}; ///< per axis of grid b
    std::ptrdiff_t count = 1;          ///< number of slots
};

PairSlots slots_of(const std::array<GridAxis, 2>& a, const std::array<GridAxis, 2>& b)
{
    PairSlots slots;
    for (std::size_t y = 2; y-- > 0;) {
        slots.b[y] = slots.count;
        std::ptrdiff_t range = b[y].cells;
        for (std::size_t x = 0; x < 2; ++x) {
            const bool same = almost_equal(a[x].step, b[y].step);
            if (slots.a[x] != 0 || !(same || almost_equal(-a[x].step, b[y].step)))
                continue;
            // For equal steps the difference of the indices matters, for opposite ones their sum.
            slots.a[x] = same ? -slots.count : slots.count;
            range += a[x].cells - 1;
            break;
        }
        slots.count *= range;
    }
    for (std::size_t x = 2; x-- > 0;)
        if (slots.a[x] == 0) {
            slots.a[x] = slots.count;
            slots.count *= a[x].cells;
        }
    return slots;
}

/// For every cell of a grid its number in the sum that is the slot.
std::vector<std::size_t> numbers_of_cells(const std::array<GridAxis, 2>& axes,
                                          const std::array<std::ptrdiff_t, 2>& strides)
{
    const auto along = [&](std::size_t k, std::uint32_t i) {
        return static_cast<std::size_t>(strides[k] < 0 ? -strides[k] * (axes[k].cells - 1 - i) : strides[k] * i);
    };
    std::vector<std::size_t> numbers;
    for (std::uint32_t i = 0; i < axes[0].cells; ++i)
        for (std::uint32_t j = 0; j < axes[1].cells; ++j)
            numbers.push_back(along(0, i) + along(1, j));
    return numbers;
}

/// Fills in the pairs of the patches of `a`, which must have the higher numbers, and those of `b`. Computes one pair
/// per slot and copies it to the others; of patches in one plane only the part in contact counts.
void fill_pairs(const Scene& scene, const std::vector<FlatPiece>& pieces, double touching, const Side& a, const Side& b,
                PairMatrix<float>& matrix)
{
    const auto a_grid = grid_of(scene, a.surface);
    const auto b_grid = grid_of(scene, b.surface);
    const PairSlots slots = slots_of(a_grid, b_grid);
    const std::vector<std::size_t> a_numbers = numbers_of_cells(a_grid, slots.a);
    const std::vector<std::size_t> b_numbers = numbers_of_cells(b_grid, slots.b);
    const bool coplanar = in_one_plane(a, b, touching);
    constexpr float unknown = -1.0f;
    std::vector<float> known(static_cast<std::size_t>(slots.count), unknown);
    for (std::uint32_t k = 0; k < a_numbers.size(); ++k) {
        const std::uint32_t i = a.first_patch + k;
        float* const row = matrix.row(i);
        for (std::uint32_t l = 0; l < b_numbers.size(); ++l) {
            const std::uint32_t j = b.first_patch + l;
            float& value = known[a_numbers[k] + b_numbers[l]];
            if (value == unknown)
                value = static_cast<float>(exchange_area(pieces[i], pieces[j], touching));
            row[j] = value;
            if (coplanar && value > 0.0f)
                row[j] *= static_cast<float>(share_in_contact(scene, i, j));
        }
    }
}

} // namespace

PairMatrix<float> unoccluded_exchange(const Scene& scene, int threads)
{
    const double touching = coplanar_distance * scene.bounds().diagonal();
    const std::vector<Side> sides = sides_of(scene);
    std::vector<FlatPiece> pieces;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        pieces.push_back(scene.patch(i).shape);
    PairMatrix<float> matrix(scene.patch_count());
    parallel_blocks(sides.size(), threads, [&](std::uint64_t number) {
        const std::uint64_t s = sides.size() - 1 - number; // long rows first
        for (std::uint64_t t = 0; t < s; ++t)
            if (may_exchange(sides[s], sides[t], touching))
                fill_pairs(scene, pieces, touching, sides[s], sides[t], matrix);
    });
    return matrix;
}

} // namespace multipath
