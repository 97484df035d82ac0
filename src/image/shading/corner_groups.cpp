// Around a corner of the lattice lie up to four cells, or six in a triangulated surface. Going around it, successive
// cells belong to one group unless an occluder separates them: a wall on a floor makes two groups, so that no light
// leaks below it. In a tessellation with cells of different sizes a corner of small cells may lie on an edge of a
// larger cell, a hanging node. Its value must be interpolated along that edge, or there would be a step.

#include "image/shading/corner_groups.h"

#include <algorithm>

namespace multipath {

namespace {

Rgb blend(double share, Rgb a, Rgb b)
{
    return (1.0 - share) * a + share * b;
}

} // namespace

std::array<std::optional<CellCorner>, 6> CornerLattice::around(std::uint32_t i, std::uint32_t j) const
{
    const std::int64_t x = i;
    const std::int64_t y = j;
    const GridPoint here = {i, j};
    if (!triangle())
        return {cell_at(x - 1, y - 1, false, here), cell_at(x, y - 1, false, here), cell_at(x, y, false, here),
                cell_at(x - 1, y, false, here)};
    return {cell_at(x, y, false, here),        cell_at(x - 1, y, true, here),  cell_at(x - 1, y, false, here),
            cell_at(x - 1, y - 1, true, here), cell_at(x, y - 1, false, here), cell_at(x, y - 1, true, here)};
}

/// The cell that contains square (i, j) of the grid, or in a triangle its lower or upper half; nothing beyond the
/// border.
std::optional<CellCorner> CornerLattice::cell_at(std::int64_t i, std::int64_t j, bool upper, GridPoint corner) const
{
    const std::int64_t columns = tessellation_.grid_u();
    const std::int64_t rows = tessellation_.grid_v();
    if (i < 0 || j < 0 || (triangle() ? i + j + (upper ? 1 : 0) >= columns : i >= columns || j >= rows))
        return std::nullopt;
    const double middle = triangle() ? (upper ? 2.0 / 3.0 : 1.0 / 3.0) : 0.5;
    const std::uint32_t cell = tessellation_.cell_at((static_cast<double>(i) + middle) / static_cast<double>(columns),
                                                     (static_cast<double>(j) + middle) / static_cast<double>(rows));
    const CellCorners corners = tessellation_.corners(cell);
    std::uint32_t number = 0;
    while (number < corners.count && (corners.points[number].i != corner.i || corners.points[number].j != corner.j))
        ++number;
    return CellCorner{cell, number < corners.count ? number : CellCorner::on_edge};
}

std::vector<GridPoint> CornerLattice::points(std::uint32_t first_row, std::uint32_t end_row) const
{
    std::vector<GridPoint> result;
    if (!tessellation_.trees) {
        for (std::uint32_t j = first_row; j < end_row; ++j)
            for (std::uint32_t i = 0; i <= last_column(j); ++i)
                result.push_back({i, j});
        return result;
    }
    for (std::uint32_t cell = 0; cell < tessellation_.cell_count(); ++cell)
        for (const GridPoint point : tessellation_.corners(cell))
            if (point.j >= first_row && point.j < end_row)
                result.push_back(point);
    const auto before = [](GridPoint a, GridPoint b) { return a.j < b.j || (a.j == b.j && a.i < b.i); };
    const auto same = [](GridPoint a, GridPoint b) { return a.j == b.j && a.i == b.i; };
    std::sort(result.begin(), result.end(), before);
    result.erase(std::unique(result.begin(), result.end(), same), result.end());
    return result;
}

Rgb CornerLattice::interpolated(const Rgb* values, double u, double v) const
{
    const std::uint32_t cell = tessellation_.cell_at(u, v);
    const CellCorners corners = tessellation_.corners(cell);
    const GridPoint origin = corners.points[0];
    const double size = static_cast<double>(corners.points[1].i) - origin.i; // negative for the upper half of a square
    const double x = std::clamp((u * tessellation_.grid_u() - origin.i) / size, 0.0, 1.0);
    const double y = std::clamp((v * tessellation_.grid_v() - origin.j) / size, 0.0, 1.0);
    const Rgb* corner = values + per_cell * cell;
    if (triangle())
        return (1.0 - x - y) * corner[0] + x * corner[1] + y * corner[2];
    return blend(y, blend(x, corner[0], corner[1]), blend(x, corner[3], corner[2]));
}

namespace {

/// Makes the corner groups of one side of a surface.
class Side
{
public:
    Side(const VisiblePatches& patches, const std::vector<PatchSlope>& slopes, std::uint32_t surface, bool front)
        : patches_(patches),
          slopes_(slopes),
          scene_(patches.scene()),
          surface_(surface),
          first_patch_(scene_.first_patch(surface, front)),
          normal_(front ? scene_.surfaces()[surface].normal() : -scene_.surfaces()[surface].normal()),
          lattice_(scene_.tessellation(surface))
    {
    }

    std::vector<CornerGroup> groups(std::uint32_t first_row, std::uint32_t end_row, bool with_points) const
    {
        std::vector<CornerGroup> result;
        for (const GridPoint point : lattice_.points(first_row, end_row))
            append_groups(point.i, point.j, with_points, result);
        return result;
    }

private:
    void append_groups(std::uint32_t i, std::uint32_t j, bool with_points, std::vector<CornerGroup>& groups) const
    {
        const std::size_t before = groups.size();
        const Vec3 corner = scene_.surfaces()[surface_].at(lattice_.u(i), lattice_.v(j));
        const std::size_t count = lattice_.most_around();
        const CellRing ring = ring_around(lattice_.around(i, j), corner);
        // The first group starts after a gap between cells, if there is one; every further gap starts another group.
        std::size_t start = 0;
        while (start < count && ring.joined[(start + count - 1) % count])
            ++start;
        const bool whole = std::all_of(ring.cells.begin(), ring.cells.begin() + static_cast<std::ptrdiff_t>(count),
                                       [](const auto& cell) { return cell.has_value(); });
        for (std::size_t step = 0; step < count; ++step) {
            const std::size_t k = (start + step) % count;
            if (!ring.cells[k])
                continue;
            if (step == 0 || !ring.joined[(k + count - 1) % count])
                groups.push_back({surface_, normal_, corner, {}, {}, 0.0, {}, !whole, {}});
            if (ring.cells[k]->number == CellCorner::on_edge)
                add_hanging_node(ring.cells[k]->cell, {i, j}, groups.back());
            else
                add(ring, k, groups.back());
            if (!whole || with_points)
                add_points(ring, k, groups.back());
        }
        const auto of_edge_only = [](const CornerGroup& group) { return group.slots.empty(); };
        groups.erase(std::remove_if(groups.begin() + static_cast<std::ptrdiff_t>(before), groups.end(), of_edge_only),
                     groups.end());
        replace_covered(groups.data() + before, groups.data() + groups.size());
    }

    /// Gives groups of weight 0 the mean value of the others: a cell that seems entirely covered may be open between
    /// its sample points. Where it is in fact covered, the value is not visible.
    static void replace_covered(CornerGroup* begin, CornerGroup* end)
    {
        Rgb sum;
        double weight = 0.0;
        for (const CornerGroup* group = begin; group != end; ++group) {
            sum += group->weight * group->value;
            weight += group->weight;
        }
        for (CornerGroup* group = begin; group != end && weight > 0.0; ++group)
            if (!(group->weight > 0.0))
                group->value = 1.0 / weight * sum;
    }

    /// The cells around a corner, counter-clockwise.
    struct CellRing
    {
        std::array<std::optional<CellCorner>, 6> cells;
        std::array<std::optional<OpenPoint>, 6> points; ///< an uncovered point of each cell near the corner
        std::array<bool, 6> joined{};                   ///< true if the cell is joined to the next one
    };

    CellRing ring_around(const std::array<std::optional<CellCorner>, 6>& cells, Vec3 corner) const
    {
        CellRing ring{cells, {}, {}};
        const std::size_t count = lattice_.most_around();
        for (std::size_t k = 0; k < count; ++k)
            if (cells[k])
                ring.points[k] = open_point(*cells[k], corner);
        for (std::size_t k = 0; k < count; ++k)
            if (cells[k] && cells[(k + 1) % count])
                ring.joined[k] = is_joined(ring, k, (k + 1) % count);
        return ring;
    }

    /// True if two neighbouring cells are not separated at the corner, or not at the middle between them: a wall
    /// separates them along the whole edge, the leg of a table does not.
    bool is_joined(const CellRing& ring, std::size_t one, std::size_t other) const
    {
        const std::optional<OpenPoint>& from = ring.points[one];
        const std::optional<OpenPoint>& to = ring.points[other];
        return (from && to && !occluded_between(scene_, *from, *to)) ||
               patches_.are_joined(first_patch_ + ring.cells[one]->cell, first_patch_ + ring.cells[other]->cell);
    }

    Vec3 centre(CellCorner cell) const { return scene_.patch(first_patch_ + cell.cell).shape.centre(); }

    std::optional<OpenPoint> open_point(CellCorner cell, Vec3 near) const
    {
        const std::optional<Vec3> point = patches_.open_point_near(first_patch_ + cell.cell, near);
        return point ? std::optional<OpenPoint>({*point, normal_}) : std::nullopt;
    }

    /// Adds a cell to the group's mean, weighted by its open share: the value of its linear function at the corner, at
    /// least 0.
    void add(const CellRing& ring, std::size_t k, CornerGroup& group) const
    {
        const auto [cell, number] = *ring.cells[k];
        const std::uint32_t patch = first_patch_ + cell;
        const double weight = patches_.open_share(patch);
        const Rgb estimate = patches_.value(patch) + slopes_[patch].at_corner(number, scene_.corners(patch).count);
        const Rgb value = by_channel([](double x) { return std::max(0.0, x); }, estimate);
        if (group.weight + weight > 0.0)
            group.value = 1.0 / (group.weight + weight) * (group.weight * group.value + weight * value);
        else
            group.value = value;
        group.weight += weight;
        group.slots.push_back(CornerLattice::per_cell * patch + number);
    }

    /// Adds the points from which connections to other surfaces are tested.
    void add_points(const CellRing& ring, std::size_t k, CornerGroup& group) const
    {
        for (const std::optional<OpenPoint>& point :
             {ring.points[k], open_point(*ring.cells[k], centre(*ring.cells[k]))})
            if (point)
                group.points.push_back(*point);
    }

    /// A corner lies on an edge of at most one larger cell, which covers all of one side.
    void add_hanging_node(std::uint32_t cell, GridPoint here, CornerGroup& group) const
    {
        const Tessellation& cut = scene_.tessellation(surface_);
        const CellCorners corners = cut.corners(cell);
        const auto difference = [](std::uint32_t a, std::uint32_t b) { return static_cast<double>(a) - b; };
        for (std::size_t k = 0; k < corners.count; ++k) {
            const GridPoint a = corners.points[k];
            const GridPoint b = corners.points[(k + 1) % corners.count];
            if (difference(b.i, a.i) * difference(here.j, a.j) != difference(b.j, a.j) * difference(here.i, a.i))
                continue;
            const double share = b.i != a.i ? difference(here.i, a.i) / difference(b.i, a.i)
                                            : difference(here.j, a.j) / difference(b.j, a.j);
            const std::size_t first = CornerLattice::per_cell * (first_patch_ + std::size_t{cell});
            group.edge = {first + k, first + (k + 1) % corners.count, share, cut.level(cell)};
        }
    }

    const VisiblePatches& patches_;
    const std::vector<PatchSlope>& slopes_;
    const Scene& scene_;
    std::uint32_t surface_;
    std::uint32_t first_patch_;
    Vec3 normal_;
    CornerLattice lattice_;
};

} // namespace

std::vector<CornerGroup> corner_groups(const VisiblePatches& patches, const std::vector<PatchSlope>& slopes,
                                       std::uint32_t surface, bool front, std::uint32_t first_row,
                                       std::uint32_t end_row, bool with_points)
{
    return Side(patches, slopes, surface, front).groups(first_row, end_row, with_points);
}

} // namespace multipath
