#include "image/shading/patch_slopes.h"

#include "image/shading/skin.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace multipath {

namespace {

/// A place on a surface in steps of its finest grid.
struct GridPlace
{
    double i;
    double j;
};

/// The patches across the edges of a patch: one for each half of each edge.
struct Neighbours
{
    std::array<std::uint32_t, 8> list;
    std::size_t count = 0;
    bool at_border = false; ///< some halves have none
};

/// A vector from the centre of a patch, in its edges.
struct Way
{
    double x;
    double y;
};

/// Sums over the ways to neighbours.
struct Moments
{
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;

    void add(Way way)
    {
        xx += way.x * way.x;
        xy += way.x * way.y;
        yy += way.y * way.y;
    }
    double determinant() const { return xx * yy - xy * xy; }
    double trace() const { return xx + yy; }
    bool on_one_line() const { return determinant() <= 1e-6 * trace() * trace(); }
};

GridPlace centre_of(const CellCorners& corners)
{
    GridPlace sum = {0.0, 0.0};
    for (const GridPoint point : corners) {
        sum.i += point.i;
        sum.j += point.j;
    }
    const auto count = static_cast<double>(corners.count);
    return {sum.i / count, sum.j / count};
}

class Slopes
{
public:
    Slopes(const VisiblePatches& patches, int threads)
        : patches_(patches), scene_(patches.scene()), fitted_(scene_.patch_count()), at_border_(scene_.patch_count())
    {
        const auto for_all = [&](const auto& make) {
            constexpr std::uint32_t patches_at_a_time = 256;
            parallel_ranges(scene_.patch_count(), patches_at_a_time, threads,
                            [&](std::uint32_t first, std::uint32_t end) {
                                for (std::uint32_t i = first; i < end; ++i)
                                    make(i);
                            });
        };
        for_all([&](std::uint32_t i) { fitted_[i] = fitted(i, at_border_[i]); });
        result_.resize(fitted_.size());
        for_all([&](std::uint32_t i) { result_[i] = at_border_[i] != 0 ? continued(i) : fitted_[i]; });
    }

    std::vector<PatchSlope> result() && { return std::move(result_); }

private:
    Neighbours neighbours(std::uint32_t patch) const
    {
        Neighbours result;
        const std::uint32_t surface = scene_.surface_of(patch);
        const Tessellation& cut = scene_.tessellation(surface);
        if (cut.cell_count() == 1 || !(patches_.open_share(patch) > 0.0))
            return result;
        const CellCorners corners = scene_.corners(patch);
        const GridPlace centre = centre_of(corners);
        const bool triangle = cut.shape == Shape::triangle;
        for (std::size_t k = 0; k < corners.count; ++k) {
            const GridPoint a = corners.points[k];
            const GridPoint b = corners.points[(k + 1) % corners.count];
            const GridPlace middle = {0.5 * a.i + 0.5 * b.i, 0.5 * a.j + 0.5 * b.j};
            constexpr double beyond = 0.05; // steps of the grid
            const double far = std::hypot(middle.i - centre.i, middle.j - centre.j);
            for (const double share : {0.25, 0.75}) {
                const GridPlace at = {(1.0 - share) * a.i + share * b.i, (1.0 - share) * a.j + share * b.j};
                const double u = (at.i + beyond * (middle.i - centre.i) / far) / cut.grid_u();
                const double v = (at.j + beyond * (middle.j - centre.j) / far) / cut.grid_v();
                if (u < 0.0 || v < 0.0 || (triangle ? u + v > 1.0 : u > 1.0 || v > 1.0)) {
                    result.at_border = true;
                    continue;
                }
                const std::uint32_t other = scene_.patch_at(surface, u, v, scene_.is_front(patch));
                if (!is_joined(patch, other)) {
                    result.at_border = true;
                    continue;
                }
                result.list[result.count++] = other;
            }
        }
        return result;
    }

    bool is_joined(std::uint32_t patch, std::uint32_t other) const
    {
        if (!(patches_.open_share(other) > 0.0))
            return false;
        const Vec3 middle = 0.5 * (scene_.patch(patch).shape.centre() + scene_.patch(other).shape.centre());
        const std::optional<Vec3> from = patches_.open_point_near(patch, middle);
        const std::optional<Vec3> to = patches_.open_point_near(other, middle);
        const Vec3 normal = scene_.patch(patch).shape.normal();
        return from && to && !parted(scene_, {*from, normal}, {*to, normal});
    }

    /// The centre and the edges of a patch on the grid.
    struct Frame
    {
        GridPlace centre;
        GridPlace u;
        GridPlace v;

        explicit Frame(const CellCorners& corners) : centre(centre_of(corners))
        {
            const GridPoint a = corners.points[0];
            const GridPoint b = corners.points[1];
            const GridPoint c = corners.points[corners.count - 1];
            u = {static_cast<double>(b.i) - a.i, static_cast<double>(b.j) - a.j};
            v = {static_cast<double>(c.i) - a.i, static_cast<double>(c.j) - a.j};
        }
        Way way(GridPlace to) const
        {
            const double det = u.i * v.j - u.j * v.i;
            const double di = to.i - centre.i;
            const double dj = to.j - centre.j;
            return {(di * v.j - dj * v.i) / det, (u.i * dj - u.j * di) / det};
        }
    };

    PatchSlope fitted(std::uint32_t patch, char& at_border) const
    {
        const Neighbours around = neighbours(patch);
        at_border = around.at_border ? 1 : 0;
        PatchSlope slope;
        if (around.count == 0)
            return slope;
        const Frame frame(scene_.corners(patch));
        const Rgb own = patches_.value(patch);
        Moments moments;
        Rgb x_value;
        Rgb y_value;
        Rgb low;
        Rgb high;
        for (std::size_t k = 0; k < around.count; ++k) {
            const Way way = frame.way(Frame(scene_.corners(around.list[k])).centre);
            const Rgb more = patches_.value(around.list[k]) - own;
            moments.add(way);
            x_value += way.x * more;
            y_value += way.y * more;
            low = {std::min(low.r, more.r), std::min(low.g, more.g), std::min(low.b, more.b)};
            high = {std::max(high.r, more.r), std::max(high.g, more.g), std::max(high.b, more.b)};
        }
        if (moments.on_one_line()) {
            const double scale = 1.0 / (moments.trace() * moments.trace());
            slope.along_u = scale * (moments.xx * x_value + moments.xy * y_value);
            slope.along_v = scale * (moments.xy * x_value + moments.yy * y_value);
        } else {
            const double scale = 1.0 / moments.determinant();
            slope.along_u = scale * (moments.yy * x_value - moments.xy * y_value);
            slope.along_v = scale * (moments.xx * y_value - moments.xy * x_value);
        }
        Rgb factor = {1.0, 1.0, 1.0}; // that keeps the function half way to the neighbours within the values around
        for (std::size_t k = 0; k < around.count; ++k) {
            const Way way = frame.way(Frame(scene_.corners(around.list[k])).centre);
            const Rgb change = 0.5 * (way.x * slope.along_u + way.y * slope.along_v);
            factor.r = std::min(factor.r, within(change.r, low.r, high.r));
            factor.g = std::min(factor.g, within(change.g, low.g, high.g));
            factor.b = std::min(factor.b, within(change.b, low.b, high.b));
        }
        return {factor * slope.along_u, factor * slope.along_v};
    }

    static double within(double change, double low, double high)
    {
        return change > high ? high / change : change < low ? low / change : 1.0;
    }

    static double smaller(double a, double b) { return a * b <= 0.0 ? 0.0 : std::abs(a) < std::abs(b) ? a : b; }
    static Rgb smaller(Rgb a, Rgb b) { return {smaller(a.r, b.r), smaller(a.g, b.g), smaller(a.b, b.b)}; }

    /// At a border: the smaller of the fitted slope and that of the neighbours; across a line on which all
    /// neighbours lie, theirs.
    PatchSlope continued(std::uint32_t patch) const
    {
        const Neighbours around = neighbours(patch);
        if (around.count == 0)
            return fitted_[patch];
        const Frame frame(scene_.corners(patch));
        PatchSlope theirs;
        Moments moments;
        for (std::size_t k = 0; k < around.count; ++k) {
            const std::uint32_t other = around.list[k];
            const Frame its(scene_.corners(other));
            const Way u = its.way({its.centre.i + frame.u.i, its.centre.j + frame.u.j}); // in its edges
            const Way v = its.way({its.centre.i + frame.v.i, its.centre.j + frame.v.j});
            theirs.along_u += u.x * fitted_[other].along_u + u.y * fitted_[other].along_v;
            theirs.along_v += v.x * fitted_[other].along_u + v.y * fitted_[other].along_v;
            moments.add(frame.way(its.centre));
        }
        const double share = 1.0 / static_cast<double>(around.count);
        theirs = {share * theirs.along_u, share * theirs.along_v};
        const PatchSlope& own = fitted_[patch];
        if (!moments.on_one_line())
            return {smaller(own.along_u, theirs.along_u), smaller(own.along_v, theirs.along_v)};
        const Way line = frame.way(Frame(scene_.corners(around.list[0])).centre);
        const double square = line.x * line.x + line.y * line.y;
        const Rgb its = line.x * theirs.along_u + line.y * theirs.along_v;
        const Rgb change = smaller(line.x * own.along_u + line.y * own.along_v, its) - its;
        return {theirs.along_u + (line.x / square) * change, theirs.along_v + (line.y / square) * change};
    }

    const VisiblePatches& patches_;
    const Scene& scene_;
    std::vector<PatchSlope> fitted_;
    std::vector<char> at_border_; ///< 1 where a part of an edge has no neighbour
    std::vector<PatchSlope> result_;
};

} // namespace

std::vector<PatchSlope> patch_slopes(const VisiblePatches& patches, int threads)
{
    return Slopes(patches, threads).result();
}

} // namespace multipath
