// Surfaces are cut into equal cells, so where two grids have a step in common (a wall and the floor along their edge,
// floor and ceiling both ways) the exchange depends on the difference of the cell numbers along it only. Every pair of
// cells gets a place number that is a sum of one number for each of the two cells; pairs that are moved along a common
// step have the same place, and only the first of them is computed.

#include "transport/exchange/unoccluded_exchange.h"

#include "geometry/form_factor/exchange_area.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/polygon.h"
#include "parallel/blocks.h"
#include "transport/exchange/contact.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace multipath {

namespace {

/// The patches on one side of a surface.
struct Side
{
    std::uint32_t surface;
    std::uint32_t first_patch;
    std::uint32_t patch_count;
    FlatPiece whole;
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

bool in_one_plane(const Side& a, const Side& b, double touching)
{
    return heights(a.outline, b.whole.centre, b.whole.normal).within(touching) ||
           heights(b.outline, a.whole.centre, a.whole.normal).within(touching);
}

bool may_exchange(const Side& a, const Side& b, double touching)
{
    if (a.surface == b.surface)
        return false;
    const HeightRange a_heights = heights(a.outline, b.whole.centre, b.whole.normal);
    const HeightRange b_heights = heights(b.outline, a.whole.centre, a.whole.normal);
    return in_one_plane(a, b, touching) || (a_heights.high > touching && b_heights.high > touching);
}

/// One direction of a surface's grid.
struct GridAxis
{
    Vec3 step; ///< from a cell to the next
    std::uint32_t cells;
};

/// Cell (i, j) has number i * axes[1].cells + j. Triangles, whose cells are not all turned alike, are one axis.
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

/// What a step along a grid's axis adds to the place number, and whether steps count from the far end.
struct Stride
{
    std::size_t stride = 0;
    bool reversed = false;
};

/// Place numbers of the pairs of cells of two grids: place(cell of a) + place(cell of b).
struct PairPlaces
{
    std::array<Stride, 2> a;
    std::array<Stride, 2> b;
    std::size_t count = 1;
    bool any_shared = false;
};

PairPlaces places_of(const std::array<GridAxis, 2>& a, const std::array<GridAxis, 2>& b)
{
    PairPlaces places;
    for (std::size_t y = 2; y-- > 0;) {
        places.b[y].stride = places.count;
        std::size_t range = b[y].cells;
        for (std::size_t x = 0; x < 2; ++x) {
            const bool same = almost_equal(a[x].step, b[y].step);
            if (places.a[x].stride > 0 || !(same || almost_equal(-a[x].step, b[y].step)))
                continue;
            // With equal steps the difference of the numbers counts, with opposite ones the sum.
            places.a[x] = {places.count, same};
            range += a[x].cells - 1;
            places.any_shared = true;
            break;
        }
        places.count *= range;
    }
    for (std::size_t x = 2; x-- > 0;)
        if (places.a[x].stride == 0) {
            places.a[x].stride = places.count;
            places.count *= a[x].cells;
        }
    return places;
}

std::vector<std::size_t> place_of_cells(const std::array<GridAxis, 2>& axes, const std::array<Stride, 2>& strides)
{
    const auto along = [&](std::size_t k, std::uint32_t i) {
        return strides[k].stride * (strides[k].reversed ? axes[k].cells - 1 - i : i);
    };
    std::vector<std::size_t> places;
    places.reserve(std::size_t{axes[0].cells} * axes[1].cells);
    for (std::uint32_t i = 0; i < axes[0].cells; ++i)
        for (std::uint32_t j = 0; j < axes[1].cells; ++j)
            places.push_back(along(0, i) + along(1, j));
    return places;
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

    /// The patches of `a` must have the higher numbers.
    void fill(const Side& a, const Side& b)
    {
        const auto a_grid = grid_of(scene_, a.surface);
        const auto b_grid = grid_of(scene_, b.surface);
        const PairPlaces places = places_of(a_grid, b_grid);
        if (places.any_shared)
            fill_moved(a, place_of_cells(a_grid, places.a), b, place_of_cells(b_grid, places.b), places.count);
        else
            fill_each(a, b);
        if (in_one_plane(a, b, touching_))
            keep_contacts(a, b);
    }

private:
    /// Patches that lie in one plane back to back see nothing of each other.
    void keep_contacts(const Side& a, const Side& b)
    {
        for (std::uint32_t i = a.first_patch; i < a.first_patch + a.patch_count; ++i) {
            float* row = matrix_.row(i);
            for (std::uint32_t j = b.first_patch; j < b.first_patch + b.patch_count; ++j)
                if (row[j] > 0.0f && !in_contact(scene_, i, j))
                    row[j] = 0.0f;
        }
    }

    float exchange(std::uint32_t i, std::uint32_t j) const
    {
        return static_cast<float>(exchange_area(pieces_[i], pieces_[j], touching_));
    }

    void fill_each(const Side& a, const Side& b)
    {
        for (std::uint32_t i = a.first_patch; i < a.first_patch + a.patch_count; ++i) {
            float* row = matrix_.row(i);
            for (std::uint32_t j = b.first_patch; j < b.first_patch + b.patch_count; ++j)
                row[j] = exchange(i, j);
        }
    }

    void fill_moved(const Side& a, const std::vector<std::size_t>& a_place, const Side& b,
                    const std::vector<std::size_t>& b_place, std::size_t place_count)
    {
        constexpr float unknown = -1.0f;
        std::vector<float> known(place_count, unknown);
        for (std::uint32_t i = 0; i < a.patch_count; ++i) {
            float* row = matrix_.row(a.first_patch + i) + b.first_patch;
            for (std::uint32_t j = 0; j < b.patch_count; ++j) {
                float& value = known[a_place[i] + b_place[j]];
                if (value == unknown)
                    value = exchange(a.first_patch + i, b.first_patch + j);
                row[j] = value;
            }
        }
    }

    const Scene& scene_;
    PairMatrix<float>& matrix_;
    double touching_;
    std::vector<FlatPiece> pieces_;
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
