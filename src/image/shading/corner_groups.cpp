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

std::vector<std::optional<CellCorner>> CornerLattice::around(GridPoint corner) const
{
    const std::int64_t x = corner.i;
    const std::int64_t y = corner.j;
    const auto cell = [&](std::int64_t i, std::int64_t j, bool upper) { return cell_at(i, j, upper, corner); };
    if (!triangle())
        return {cell(x - 1, y - 1, false), cell(x, y - 1, false), cell(x, y, false), cell(x - 1, y, false)};
    return {cell(x, y, false),        cell(x - 1, y, true),  cell(x - 1, y, false),
            cell(x - 1, y - 1, true), cell(x, y - 1, false), cell(x, y - 1, true)};
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

std::vector<GridPoint> CornerLattice::points() const
{
    std::vector<GridPoint> result;
    if (!tessellation_.trees) {
        for (std::uint32_t j = 0; j <= tessellation_.grid_v(); ++j)
            for (std::uint32_t i = 0; i <= tessellation_.grid_u() - (triangle() ? j : 0); ++i)
                result.push_back({i, j});
        return result;
    }
    for (std::uint32_t cell = 0; cell < tessellation_.cell_count(); ++cell)
        for (const GridPoint point : tessellation_.corners(cell))
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
          front_(front),
          first_patch_(scene_.first_patch(surface, front)),
          normal_(front ? scene_.surfaces()[surface].normal() : -scene_.surfaces()[surface].normal()),
          lattice_(scene_.tessellation(surface))
    {
    }

    std::vector<CornerGroup> groups() const
    {
        std::vector<CornerGroup> result;
        for (const GridPoint point : lattice_.points())
            append_groups(point, result);
        return result;
    }

private:
    void append_groups(GridPoint place, std::vector<CornerGroup>& groups) const
    {
        const std::size_t before = groups.size();
        const Vec3 corner = scene_.surfaces()[surface_].at(lattice_.u(place), lattice_.v(place));
        const std::vector<RingCell> ring = ring_around(place, corner);
        const std::size_t count = ring.size();
        // The first group starts after a gap between cells, if there is one; every further gap starts another group.
        std::size_t start = 0;
        while (start < count && ring[(start + count - 1) % count].joined)
            ++start;
        const bool on_border = std::any_of(ring.begin(), ring.end(), [](const RingCell& cell) { return !cell.cell; });
        for (std::size_t step = 0; step < count; ++step) {
            const RingCell& here = ring[(start + step) % count];
            if (!here.cell)
                continue;
            if (step == 0 || !ring[(start + step + count - 1) % count].joined)
                groups.push_back({surface_, front_, normal_, corner, {}, {}, 0.0, on_border, {}, {}});
            if (here.cell->number == CellCorner::on_edge)
                groups.back().edge = edge_through(here.cell->cell, place);
            else
                add(*here.cell, groups.back());
            if (on_border)
                for (const std::optional<OpenPoint>& point : {here.point, open_point(*here.cell, centre(*here.cell))})
                    if (point)
                        groups.back().points.push_back(*point);
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

    /// One of the cells around a corner.
    struct RingCell
    {
        std::optional<CellCorner> cell;
        std::optional<OpenPoint> point; ///< an uncovered point of the cell near the corner
        bool joined = false;            ///< true if the cell is joined to the next one
    };

    std::vector<RingCell> ring_around(GridPoint place, Vec3 corner) const
    {
        std::vector<RingCell> ring;
        for (const std::optional<CellCorner>& cell : lattice_.around(place))
            ring.push_back({cell, cell ? open_point(*cell, corner) : std::nullopt});
        for (std::size_t k = 0; k < ring.size(); ++k)
            ring[k].joined = is_joined(ring[k], ring[(k + 1) % ring.size()]);
        return ring;
    }

    /// True if two neighbouring cells are not separated at the corner, or not at the middle between them: a wall
    /// separates them along the whole edge, the leg of a table does not.
    bool is_joined(const RingCell& from, const RingCell& to) const
    {
        return from.cell && to.cell &&
               ((from.point && to.point && !occluded_between(scene_, *from.point, *to.point)) ||
                patches_.are_joined(first_patch_ + from.cell->cell, first_patch_ + to.cell->cell));
    }

    Vec3 centre(CellCorner cell) const { return scene_.patch(first_patch_ + cell.cell).shape.centre(); }

    std::optional<OpenPoint> open_point(CellCorner cell, Vec3 near) const
    {
        const std::optional<Vec3> point = patches_.open_point_near(first_patch_ + cell.cell, near);
        return point ? std::optional<OpenPoint>({*point, normal_}) : std::nullopt;
    }

    /// Adds a cell to the group's mean, weighted by its open share: the value of its linear function at the corner, at
    /// least 0.
    void add(CellCorner corner, CornerGroup& group) const
    {
        const auto [cell, number] = corner;
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

    /// The edge of a cell on which a hanging node lies. It lies on an edge of at most one larger cell, which covers all
    /// of one side.
    std::optional<CornerGroup::Edge> edge_through(std::uint32_t cell, GridPoint here) const
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
            return CornerGroup::Edge{first + k, first + (k + 1) % corners.count, share, cut.level(cell)};
        }
        return std::nullopt;
    }

    const VisiblePatches& patches_;
    const std::vector<PatchSlope>& slopes_;
    const Scene& scene_;
    std::uint32_t surface_;
    bool front_;
    std::uint32_t first_patch_;
    Vec3 normal_;
    CornerLattice lattice_;
};

} // namespace

std::vector<CornerGroup> corner_groups(const VisiblePatches& patches, const std::vector<PatchSlope>& slopes,
                                       std::uint32_t surface, bool front)
{
    return Side(patches, slopes, surface, front).groups();
}

} // namespace multipath
