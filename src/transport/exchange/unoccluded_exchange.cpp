#include "transport/exchange/unoccluded_exchange.h"

#include "geometry/form_factor/exchange_area.h"
#include "geometry/intersector/intersector.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/polygon.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace multipath {

namespace {

/// Coordinates in the plane of a shape: those of its surface, with (0, 0) at its origin and 1 at the end of each edge.
class EdgeCoordinates
{
public:
    explicit EdgeCoordinates(const Surface& shape)
        : shape_(shape), normal_(cross(shape.edge_u, shape.edge_v)), scale_(1.0 / dot(normal_, normal_))
    {
    }

    double u(Vec3 from_origin) const { return scale_ * dot(cross(from_origin, shape_.edge_v), normal_); }
    double v(Vec3 from_origin) const { return scale_ * dot(cross(shape_.edge_u, from_origin), normal_); }

    /// True if a point of the plane of the shape lies inside it, clear of its border.
    bool contains(Vec3 point) const
    {
        const double at_u = u(point - shape_.origin);
        const double at_v = v(point - shape_.origin);
        const bool in_triangle = shape_.shape == Shape::parallelogram || at_u + at_v < 1.0 - inset;
        return at_u > inset && at_v > inset && at_u < 1.0 - inset && at_v < 1.0 - inset && in_triangle;
    }

    /// The range {first, last} of k in 0 ... count - 1 that contains all points start + k step inside the shape, to be
    /// tested by contains(); last < first if there are none.
    std::pair<int, int> range_inside(Vec3 start, Vec3 step, int count) const
    {
        const double at_u = u(start - shape_.origin);
        const double at_v = v(start - shape_.origin);
        const double step_u = u(step);
        const double step_v = v(step);
        double first = 0.0;
        double last = count - 1.0;
        const auto require_positive = [&](double at, double slope) { // at + k slope > 0
            if (slope > 0.0)
                first = std::max(first, -at / slope);
            else if (slope < 0.0)
                last = std::min(last, -at / slope);
            else if (!(at > 0.0))
                last = -1.0;
        };
        require_positive(at_u, step_u);
        require_positive(at_v, step_v);
        require_positive(1.0 - at_u, -step_u);
        require_positive(1.0 - at_v, -step_v);
        if (shape_.shape == Shape::triangle)
            require_positive(1.0 - at_u - at_v, -step_u - step_v);
        return first <= last ? std::pair<int, int>{static_cast<int>(first), static_cast<int>(std::ceil(last))}
                             : std::pair<int, int>{0, -1};
    }

private:
    static constexpr double inset = 1e-4; ///< share of an edge

    Surface shape_;
    Vec3 normal_;
    double scale_;
};

/// The points of a grid x grid pattern on the first shape that are inside both shapes.
std::vector<Vec3> common_points(const Surface& small, const Surface& large, int grid)
{
    const EdgeCoordinates on_small(small);
    const EdgeCoordinates on_large(large);
    std::vector<Vec3> points;
    for (int i = 0; i < grid; ++i) {
        const auto point = [&](int j) { return small.at((i + 0.5) / grid, (j + 0.5) / grid); };
        const auto [first, last] = on_large.range_inside(point(0), (1.0 / grid) * small.edge_v, grid);
        for (int j = first; j <= last; ++j)
            if (on_small.contains(point(j)) && on_large.contains(point(j)))
                points.push_back(point(j));
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
    std::uint32_t patch_count;
    FlatPiece whole; ///< of the surface, with this side as its front
    FlatPolygon outline;
};

std::vector<Side> sides_of(const Scene& scene)
{
    std::vector<Side> sides;
    const std::uint32_t cells = scene.two_sided() ? scene.patch_count() / 2 : scene.patch_count();
    for (std::uint32_t first_cell = 0; first_cell < scene.patch_count(); first_cell += cells)
        for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s) {
            Surface shape = scene.surfaces()[s];
            if (first_cell > 0)
                std::swap(shape.edge_u, shape.edge_v);
            sides.push_back({s, first_cell + scene.first_patch(s),
                             static_cast<std::uint32_t>(scene.tessellation(s).cell_count()), piece_of(shape),
                             polygon_of(shape)});
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

/// The contribution of one grid axis to the slot.
struct Stride
{
    std::size_t stride = 0; ///< per step
    bool reversed = false;  ///< steps are counted from the last cell
};

/// Slots of the pairs of cells of two grids: the sum of a number of the cell of a and one of the cell of b.
struct PairSlots
{
    std::array<Stride, 2> a; ///< per axis of grid a
    std::array<Stride, 2> b; ///< per axis of grid b
    std::size_t count = 1;   ///< number of slots
};

PairSlots slots_of(const std::array<GridAxis, 2>& a, const std::array<GridAxis, 2>& b)
{
    PairSlots slots;
    for (std::size_t y = 2; y-- > 0;) {
        slots.b[y].stride = slots.count;
        std::size_t range = b[y].cells;
        for (std::size_t x = 0; x < 2; ++x) {
            const bool same = almost_equal(a[x].step, b[y].step);
            if (slots.a[x].stride > 0 || !(same || almost_equal(-a[x].step, b[y].step)))
                continue;
            // For equal steps the difference of the indices matters, for opposite ones their sum.
            slots.a[x] = {slots.count, same};
            range += a[x].cells - 1;
            break;
        }
        slots.count *= range;
    }
    for (std::size_t x = 2; x-- > 0;)
        if (slots.a[x].stride == 0) {
            slots.a[x].stride = slots.count;
            slots.count *= a[x].cells;
        }
    return slots;
}

/// For every cell of a grid its number in the sum that is the slot.
std::vector<std::size_t> numbers_of_cells(const std::array<GridAxis, 2>& axes, const std::array<Stride, 2>& strides)
{
    const auto along = [&](std::size_t k, std::uint32_t i) {
        return strides[k].stride * (strides[k].reversed ? axes[k].cells - 1 - i : i);
    };
    std::vector<std::size_t> slots;
    slots.reserve(std::size_t{axes[0].cells} * axes[1].cells);
    for (std::uint32_t i = 0; i < axes[0].cells; ++i)
        for (std::uint32_t j = 0; j < axes[1].cells; ++j)
            slots.push_back(along(0, i) + along(1, j));
    return slots;
}

/// Fills the matrix for the pairs of cells of two sides.
class SidePairs
{
public:
    SidePairs(const Scene& scene, PairMatrix<float>& matrix)
        : scene_(scene), matrix_(matrix), touching_(coplanar_distance * scene.bounds().diagonal())
    {
        pieces_.reserve(scene.patch_count());
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            pieces_.push_back(piece_of(scene.patch(i).shape));
    }

    double touching() const { return touching_; }

    /// Fills in the pairs of `a`, whose patches must have the higher numbers, and `b`.
    void fill(const Side& a, const Side& b)
    {
        const auto a_grid = grid_of(scene_, a.surface);
        const auto b_grid = grid_of(scene_, b.surface);
        const PairSlots slots = slots_of(a_grid, b_grid);
        fill_slots(a, numbers_of_cells(a_grid, slots.a), b, numbers_of_cells(b_grid, slots.b), slots.count);
        if (in_one_plane(a, b, touching_))
            keep_contacts(a, b);
    }

private:
    /// Leaves only the part of the exchange of patches in one plane that are in contact.
    void keep_contacts(const Side& a, const Side& b)
    {
        for (std::uint32_t i = a.first_patch; i < a.first_patch + a.patch_count; ++i) {
            float* row = matrix_.row(i);
            for (std::uint32_t j = b.first_patch; j < b.first_patch + b.patch_count; ++j)
                if (row[j] > 0.0f)
                    row[j] *= static_cast<float>(share_in_contact(scene_, i, j));
        }
    }

    /// Computes one pair per slot and copies it to the others.
    void fill_slots(const Side& a, const std::vector<std::size_t>& a_number, const Side& b,
                    const std::vector<std::size_t>& b_number, std::size_t slot_count)
    {
        constexpr float unknown = -1.0f;
        std::vector<float> known(slot_count, unknown);
        for (std::uint32_t i = 0; i < a.patch_count; ++i) {
            float* row = matrix_.row(a.first_patch + i) + b.first_patch;
            for (std::uint32_t j = 0; j < b.patch_count; ++j) {
                float& value = known[a_number[i] + b_number[j]];
                if (value == unknown)
                    value = static_cast<float>(
                        exchange_area(pieces_[a.first_patch + i], pieces_[b.first_patch + j], touching_));
                row[j] = value;
            }
        }
    }

    const Scene& scene_;
    PairMatrix<float>& matrix_;
    double touching_;
    std::vector<FlatPiece> pieces_; ///< per patch
};

} // namespace

PairMatrix<float> unoccluded_exchange(const Scene& scene, int threads)
{
    PairMatrix<float> matrix(scene.patch_count());
    const std::vector<Side> sides = sides_of(scene);
    SidePairs pairs(scene, matrix);
    parallel_blocks(sides.size(), threads, [&](std::uint64_t number) {
        const std::uint64_t s = sides.size() - 1 - number; // long rows first
        for (std::uint64_t t = 0; t < s; ++t)
            if (may_exchange(sides[s], sides[t], pairs.touching()))
                pairs.fill(sides[s], sides[t]);
    });
    return matrix;
}

} // namespace multipath
