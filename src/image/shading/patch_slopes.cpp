// The slopes are found in the coordinates of a patch: its edges are the unit vectors, its centroid is the origin. First
// every patch gets the slope of a least-squares fit to its neighbours. At a border the neighbours lie on one side only,
// so that this is the slope halfway between the centroids rather than at the patch. There the slope is extrapolated in
// a second pass from the fits of the neighbours.

#include "image/shading/patch_slopes.h"

#include "base/elementary.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <array>

namespace multipath {

void SlopeFit::add(double weight, Vec3 way, Rgb change)
{
    xx_ += weight * way.x * way.x;
    xy_ += weight * way.x * way.y;
    yy_ += weight * way.y * way.y;
    x_value_ += weight * way.x * change;
    y_value_ += weight * way.y * change;
    low_ = by_channel([](double a, double b) { return std::min(a, b); }, low_, change);
    high_ = by_channel([](double a, double b) { return std::max(a, b); }, high_, change);
}

PatchSlope SlopeFit::slope() const
{
    if (on_one_line()) {
        const double scale = quotient(1.0, trace() * trace());
        return {scale * (xx_ * x_value_ + xy_ * y_value_), scale * (xy_ * x_value_ + yy_ * y_value_)};
    }
    const double scale = 1.0 / determinant();
    return {scale * (yy_ * x_value_ - xy_ * y_value_), scale * (xx_ * y_value_ - xy_ * x_value_)};
}

namespace {

// Positions and vectors on a surface, either in steps of its finest grid or in the coordinates of a patch, have z = 0.

Vec3 place_of(GridPoint point)
{
    return {static_cast<double>(point.i), static_cast<double>(point.j), 0.0};
}

/// The patches across the edges of a patch, one for each half of an edge: a patch may appear twice.
struct Neighbours
{
    std::array<std::uint32_t, 8> list;
    std::uint8_t count = 0;
    bool at_border = false; ///< some half of an edge has no neighbour

    const std::uint32_t* begin() const { return list.data(); }
    const std::uint32_t* end() const { return list.data() + count; }
};

Vec3 centre_of(const CellCorners& corners)
{
    Vec3 sum;
    for (const GridPoint point : corners)
        sum = sum + place_of(point);
    const auto count = static_cast<double>(corners.count);
    return {sum.x / count, sum.y / count, 0.0};
}

/// Factor in [0, 1] that brings a change into [low, high].
double within(double change, double low, double high)
{
    return change > high ? high / change : change < low ? low / change : 1.0;
}

/// Slope at a border patch by linear extrapolation of the slope, as of a quadratic function: `own` is the slope half a
/// step inside, `inner` that a whole step inside. The result is limited to between 0 and twice `inner`.
Rgb at_end(Rgb own, Rgb inner)
{
    const auto limited = [](double half, double whole) {
        const double slope = 2.0 * half - whole;
        return whole > 0.0 ? std::clamp(slope, 0.0, 2.0 * whole) : std::clamp(slope, 2.0 * whole, 0.0);
    };
    return by_channel(limited, own, inner);
}

/// Computes the slopes of all patches.
class Slopes
{
public:
    Slopes(const VisiblePatches& patches, int threads)
        : patches_(patches),
          scene_(patches.scene()),
          threads_(threads),
          around_(parallel_list(scene_.patch_count(), threads_, [&](std::uint32_t i) { return neighbours(i); }))
    {
    }

    std::vector<PatchSlope> slopes() const
    {
        const std::vector<PatchSlope> fits =
            parallel_list(scene_.patch_count(), threads_, [&](std::uint32_t i) { return fitted(i); });
        return parallel_list(scene_.patch_count(), threads_,
                             [&](std::uint32_t i) { return around_[i].at_border ? continued(i, fits) : fits[i]; });
    }

    std::vector<double> bends(const std::vector<PatchSlope>& slopes) const
    {
        return parallel_list(scene_.patch_count(), threads_, [&](std::uint32_t i) { return bend(i, slopes); });
    }

private:
    Neighbours neighbours(std::uint32_t patch) const
    {
        Neighbours result;
        const std::uint32_t surface = scene_.surface_of(patch);
        const Tessellation& cut = scene_.tessellation(surface);
        if (cut.cell_count() == 1 || !(patches_.open_share(patch) > 0.0))
            return result;
        const CellCorners corners = scene_.corners(patch);
        const Vec3 centre = centre_of(corners);
        const bool triangle = cut.shape == Shape::triangle;
        for (std::size_t k = 0; k < corners.count; ++k) {
            const Vec3 a = place_of(corners.points[k]);
            const Vec3 b = place_of(corners.points[(k + 1) % corners.count]);
            const Vec3 outward = 0.5 * a + 0.5 * b - centre;
            constexpr double beyond = 0.05; // [grid steps] distance of the test points from the edge
            const double far = elementary::hypot(outward.x, outward.y);
            for (const double share : {0.25, 0.75}) {
                const Vec3 at = (1.0 - share) * a + share * b;
                const double u = (at.x + beyond * outward.x / far) / cut.grid_u();
                const double v = (at.y + beyond * outward.y / far) / cut.grid_v();
                if (u < 0.0 || v < 0.0 || (triangle ? u + v > 1.0 : u > 1.0 || v > 1.0)) {
                    result.at_border = true;
                    continue;
                }
                const std::uint32_t other = scene_.patch_at(surface, u, v, scene_.is_front(patch));
                if (patches_.are_joined(patch, other))
                    result.list[result.count++] = other;
                else
                    result.at_border = true;
            }
        }
        return result;
    }

    /// The coordinate system of a patch: centroid and edges on the grid.
    struct Frame
    {
        Vec3 centre;
        Vec3 u;
        Vec3 v;

        explicit Frame(const CellCorners& corners)
            : centre(centre_of(corners)),
              u(place_of(corners.points[1]) - place_of(corners.points[0])),
              v(place_of(corners.points[corners.count - 1]) - place_of(corners.points[0]))
        {
        }
        /// The vector from the centroid to a point of the grid, in the coordinates of the patch.
        Vec3 way(Vec3 to) const
        {
            const double det = cross(u, v).z;
            return {cross(to - centre, v).z / det, cross(u, to - centre).z / det, 0.0};
        }
        /// Change of a function with this slope over a step on the grid.
        Rgb change(const PatchSlope& slope, Vec3 step) const
        {
            const Vec3 there = way(centre + step);
            return there.x * slope.along_u + there.y * slope.along_v;
        }
    };

    /// Least-squares slope with the limiter of Barth and Jespersen.
    PatchSlope fitted(std::uint32_t patch) const
    {
        const Frame frame(scene_.corners(patch));
        SlopeFit fit;
        for (const std::uint32_t other : around_[patch])
            fit.add(1.0, frame.way(centre_of(scene_.corners(other))), patches_.value(other) - patches_.value(patch));
        const PatchSlope slope = fit.slope();
        // The limiter keeps the function halfway to each neighbour within the range of the values.
        Rgb factor = {1.0, 1.0, 1.0};
        for (const std::uint32_t other : around_[patch]) {
            const Vec3 way = frame.way(centre_of(scene_.corners(other)));
            const Rgb change = 0.5 * (way.x * slope.along_u + way.y * slope.along_v);
            factor = by_channel([](double a, double b) { return std::min(a, b); }, factor,
                                by_channel(within, change, fit.low(), fit.high()));
        }
        return {factor * slope.along_u, factor * slope.along_v};
    }

    /// Extrapolated slope of a patch at a border. If all neighbours lie on one line, the slope across it is the mean of
    /// theirs.
    PatchSlope continued(std::uint32_t patch, const std::vector<PatchSlope>& fits) const
    {
        const Neighbours& around = around_[patch];
        if (around.count == 0)
            return fits[patch];
        const Frame frame(scene_.corners(patch));
        PatchSlope theirs;
        SlopeFit fit;
        for (const std::uint32_t other : around) {
            const Frame its(scene_.corners(other));
            theirs.along_u += its.change(fits[other], frame.u);
            theirs.along_v += its.change(fits[other], frame.v);
            fit.add(1.0, frame.way(its.centre), {});
        }
        const double share = 1.0 / static_cast<double>(around.count);
        theirs = {share * theirs.along_u, share * theirs.along_v};
        const PatchSlope& own = fits[patch];
        if (!fit.on_one_line())
            return {at_end(own.along_u, theirs.along_u), at_end(own.along_v, theirs.along_v)};
        const Vec3 line = frame.way(centre_of(scene_.corners(around.list[0])));
        const double square = dot(line, line);
        const Rgb its = line.x * theirs.along_u + line.y * theirs.along_v;
        const Rgb change = at_end(line.x * own.along_u + line.y * own.along_v, its) - its;
        return {theirs.along_u + (line.x / square) * change, theirs.along_v + (line.y / square) * change};
    }

    /// Mean square of the second derivative towards the neighbours, see patch_slopes().
    double bend(std::uint32_t patch, const std::vector<PatchSlope>& slopes) const
    {
        const Neighbours& around = around_[patch];
        if (around.count == 0)
            return 0.0;
        const Frame frame(scene_.corners(patch));
        double sum = 0.0;
        for (const std::uint32_t other : around) {
            const Frame its(scene_.corners(other));
            const Vec3 step = its.centre - frame.centre;
            const Vec3 way = frame.way(its.centre);
            const Rgb turn = its.change(slopes[other], step) - frame.change(slopes[patch], step);
            const double square = dot(way, way);
            sum += mean(turn * turn) / (square * square);
        }
        // Towards an edge of the room radiosity behaves like x log x, so that the extrapolated slope is too small.
        constexpr double at_border = 40.0; // empirical
        return (around.at_border ? at_border : 1.0) * sum / static_cast<double>(around.count);
    }

    const VisiblePatches& patches_;
    const Scene& scene_;
    int threads_;
    std::vector<Neighbours> around_; ///< per patch
};

} // namespace

std::vector<PatchSlope> patch_slopes(const VisiblePatches& patches, int threads, std::vector<double>* bends)
{
    const Slopes found(patches, threads);
    std::vector<PatchSlope> result = found.slopes();
    if (bends != nullptr)
        *bends = found.bends(result);
    return result;
}

} // namespace multipath
