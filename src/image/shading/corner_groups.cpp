#include "image/shading/corner_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace multipath {

namespace {

std::optional<CellCorner> corner_of(std::optional<std::uint32_t> cell, std::uint32_t number)
{
    return cell ? std::optional<CellCorner>({*cell, number}) : std::nullopt;
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

std::array<std::optional<CellCorner>, 6> CornerLattice::around(std::uint32_t i, std::uint32_t j) const
{
    const std::int64_t x = i;
    const std::int64_t y = j;
    if (!triangle())
        return {corner_of(rectangle(x - 1, y - 1), 2), corner_of(rectangle(x, y - 1), 3), corner_of(rectangle(x, y), 0),
                corner_of(rectangle(x - 1, y), 1)};
    return {corner_of(upright_triangle(x, y), 0),     corner_of(turned_triangle(x - 1, y), 2),
            corner_of(upright_triangle(x - 1, y), 1), corner_of(turned_triangle(x - 1, y - 1), 0),
            corner_of(upright_triangle(x, y - 1), 2), corner_of(turned_triangle(x, y - 1), 1)};
}

std::optional<std::uint32_t> CornerLattice::cell_beside(std::uint32_t cell, int along_u, int along_v) const
{
    return rectangle(std::int64_t{cell / tessellation_.cells_v} + along_u,
                     std::int64_t{cell % tessellation_.cells_v} + along_v);
}

std::optional<std::uint32_t> CornerLattice::rectangle(std::int64_t i, std::int64_t j) const
{
    if (i < 0 || j < 0 || i >= cells_u() || j >= tessellation_.cells_v)
        return std::nullopt;
    return static_cast<std::uint32_t>(i * tessellation_.cells_v + j);
}

std::optional<std::uint32_t> CornerLattice::upright_triangle(std::int64_t i, std::int64_t j) const
{
    if (i < 0 || j < 0 || i + j >= cells_u())
        return std::nullopt;
    const auto column = static_cast<std::uint64_t>(i);
    return static_cast<std::uint32_t>(Tessellation::cells_before_column(column, cells_u())) +
           static_cast<std::uint32_t>(2 * j);
}

/// The other half of the square whose first half is upright.
std::optional<std::uint32_t> CornerLattice::turned_triangle(std::int64_t i, std::int64_t j) const
{
    if (i < 0 || j < 0 || i + j + 1 >= cells_u())
        return std::nullopt;
    return *upright_triangle(i, j) + 1;
}

Rgb CornerLattice::interpolated(const Rgb* values, double u, double v) const
{
    const double x = u * tessellation_.cells_u;
    const double y = v * tessellation_.cells_v;
    const std::uint32_t i = cell_of(x, cells_u());
    const std::uint32_t j = cell_of(y, triangle() ? cells_u() - i : tessellation_.cells_v);
    const double right = std::clamp(x - i, 0.0, 1.0);
    const double up = std::clamp(y - j, 0.0, 1.0);
    if (!triangle()) {
        const Rgb* corner = values + per_cell * *rectangle(i, j);
        return blend(up, blend(right, corner[0], corner[1]), blend(right, corner[3], corner[2]));
    }
    const std::optional<std::uint32_t> turned = turned_triangle(i, j);
    if (right + up <= 1.0 || !turned) {
        const Rgb* corner = values + per_cell * *upright_triangle(i, j);
        return (1.0 - right - up) * corner[0] + right * corner[1] + up * corner[2];
    }
    const Rgb* corner = values + per_cell * *turned;
    return (right + up - 1.0) * corner[0] + (1.0 - right) * corner[1] + (1.0 - up) * corner[2];
}

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

Rgb not_negative(Rgb a)
{
    return {std::max(0.0, a.r), std::max(0.0, a.g), std::max(0.0, a.b)};
}

/// The corners of one side of one surface.
class Side
{
public:
    Side(const VisiblePatches& patches, std::uint32_t surface, bool front)
        : patches_(patches),
          scene_(patches.scene()),
          surface_(surface),
          first_patch_(scene_.first_patch(surface, front)),
          normal_(front ? scene_.surfaces()[surface].normal() : -scene_.surfaces()[surface].normal()),
          lattice_(scene_.tessellation(surface))
    {
    }

    const CornerLattice& lattice() const { return lattice_; }

    void append_groups(std::uint32_t i, std::uint32_t j, bool with_points, std::vector<CornerGroup>& groups) const
    {
        const Vec3 corner = scene_.surfaces()[surface_].at(lattice_.u(i), lattice_.v(j));
        const std::size_t count = lattice_.most_around();
        const Turn turn = turn_around(lattice_.around(i, j), corner);
        // A turn begins behind a gap, if there is one; its steps go on until the next gap.
        std::size_t start = 0;
        while (start < count && turn.joined[(start + count - 1) % count])
            ++start;
        const bool whole = std::all_of(turn.cells.begin(), turn.cells.begin() + static_cast<std::ptrdiff_t>(count),
                                       [](const auto& cell) { return cell.has_value(); });
        for (std::size_t step = 0; step < count; ++step) {
            const std::size_t k = (start + step) % count;
            if (!turn.cells[k])
                continue;
            if (step == 0 || !turn.joined[(k + count - 1) % count])
                groups.push_back({surface_, normal_, corner, {}, {}, 0.0, {}, !whole});
            add(turn, k, groups.back());
            if (!whole || with_points)
                add_points(turn, k, groups.back());
        }
    }

private:
    /// The cells around a corner, and which of them are joined to the next one.
    struct Turn
    {
        std::array<std::optional<CellCorner>, 6> cells;
        std::array<std::optional<OpenPoint>, 6> points; ///< of the cells, close to the corner
        std::array<bool, 6> joined{};
    };

    Turn turn_around(const std::array<std::optional<CellCorner>, 6>& cells, Vec3 corner) const
    {
        Turn turn{cells, {}, {}};
        const std::size_t count = lattice_.most_around();
        for (std::size_t k = 0; k < count; ++k)
            if (cells[k])
                turn.points[k] = open_point(*cells[k], corner);
        for (std::size_t k = 0; k < count; ++k)
            if (cells[k] && cells[(k + 1) % count])
                turn.joined[k] = is_joined(turn, k, (k + 1) % count);
        return turn;
    }

    /// A wall parts two neighbours from end to end, the leg of a table does not: so they are joined if one of two
    /// places along the edge between them is free: at the corner, and in the middle.
    bool is_joined(const Turn& turn, std::size_t one, std::size_t other) const
    {
        if (is_free(turn.points[one], turn.points[other]))
            return true;
        const Vec3 middle = 0.5 * (centre(*turn.cells[one]) + centre(*turn.cells[other]));
        return is_free(open_point(*turn.cells[one], middle), open_point(*turn.cells[other], middle));
    }

    bool is_free(const std::optional<OpenPoint>& from, const std::optional<OpenPoint>& to) const
    {
        return from && to && !parted(scene_, *from, *to);
    }

    Vec3 centre(CellCorner cell) const { return scene_.patch(first_patch_ + cell.cell).shape.centre(); }

    std::optional<OpenPoint> open_point(CellCorner cell, Vec3 near) const
    {
        const std::optional<Vec3> point = patches_.open_point_near(first_patch_ + cell.cell, near);
        return point ? std::optional<OpenPoint>({*point, normal_}) : std::nullopt;
    }

    /// Adds a cell to the group's mean, weighted with what of it is in the open.
    void add(const Turn& turn, std::size_t k, CornerGroup& group) const
    {
        const std::uint32_t patch = first_patch_ + turn.cells[k]->cell;
        const double weight = patches_.open_share(patch);
        const Rgb value = estimate(turn, k);
        if (group.weight + weight > 0.0)
            group.value = 1.0 / (group.weight + weight) * (group.weight * group.value + weight * value);
        else
            group.value = value;
        group.weight += weight;
        group.places.push_back(CornerLattice::per_cell * patch + turn.cells[k]->number);
    }

    /// Points from which other surfaces are looked for, at the border.
    void add_points(const Turn& turn, std::size_t k, CornerGroup& group) const
    {
        for (const std::optional<OpenPoint>& point :
             {turn.points[k], open_point(*turn.cells[k], centre(*turn.cells[k]))})
            if (point)
                group.points.push_back(*point);
    }

    /// A cell's estimate of the value at its corner: its own value, extrapolated by half a cell in directions without a
    /// joined neighbour.
    Rgb estimate(const Turn& turn, std::size_t k) const
    {
        const std::uint32_t cell = turn.cells[k]->cell;
        const Rgb own = patches_.value(first_patch_ + cell);
        if (scene_.tessellation(surface_).shape == Shape::triangle)
            return own;
        const bool next_joined = turn.joined[k];
        const bool last_joined = turn.joined[(k + 3) % 4];
        const std::uint32_t number = turn.cells[k]->number;
        const int inward_u = number == 0 || number == 3 ? 1 : -1;
        const int inward_v = number < 2 ? 1 : -1;
        Rgb result = own;
        if (!(k % 2 == 0 ? next_joined : last_joined))
            result += 0.5 * (beyond(cell, inward_u, 0) - own);
        if (!(k % 2 == 0 ? last_joined : next_joined))
            result += 0.5 * (beyond(cell, 0, inward_v) - own);
        return not_negative(result);
    }

    /// The value one step outside a cell, continued from the cells in the other direction.
    Rgb beyond(std::uint32_t cell, int inward_u, int inward_v) const
    {
        const Rgb own = patches_.value(first_patch_ + cell);
        const std::optional<Rgb> second = open_value(lattice_.cell_beside(cell, inward_u, inward_v));
        const std::optional<Rgb> third = open_value(lattice_.cell_beside(cell, 2 * inward_u, 2 * inward_v));
        if (!second)
            return own;
        // Two patches have one slope, which is all there is to continue.
        return extrapolated(own, *second, third ? *third : *second - (own - *second));
    }

    std::optional<Rgb> open_value(std::optional<std::uint32_t> cell) const
    {
        if (!cell || !(patches_.open_share(first_patch_ + *cell) > 0.0))
            return std::nullopt;
        return patches_.value(first_patch_ + *cell);
    }

    const VisiblePatches& patches_;
    const Scene& scene_;
    std::uint32_t surface_;
    std::uint32_t first_patch_;
    Vec3 normal_;
    CornerLattice lattice_;
};

} // namespace

std::vector<CornerGroup> corner_groups(const VisiblePatches& patches, std::uint32_t surface, bool front,
                                       std::uint32_t first_row, std::uint32_t end_row, bool with_points)
{
    const Side side(patches, surface, front);
    std::vector<CornerGroup> groups;
    for (std::uint32_t j = first_row; j < end_row; ++j)
        for (std::uint32_t i = 0; i <= side.lattice().last_column(j); ++i)
            side.append_groups(i, j, with_points, groups);
    return groups;
}

} // namespace multipath
