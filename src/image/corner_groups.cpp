#include "image/corner_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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

    /// What a cell says of its corner: its own value, half a step on towards where it has no joined neighbour.
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
