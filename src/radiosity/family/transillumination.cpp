// A bundle is a set of parallel lines that start at the points of a shifted Fibonacci lattice on a rectangle across
// their direction. Along each line, all pairs of patches that it joins exchange power: their radiosity times the
// section of the rectangle that a line represents, times a constant over the number of directions (P1). Each iteration
// uses one or more directions, and the mean of the iterations is the result (JacobiIterations).

#include "radiosity/family/transillumination.h"

#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "parallel/stage.h"
#include "radiosity/family/stochastic_jacobi.h"
#include "sampling/warp.h"
#include "transport/lines/line_segments.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

double wrapped(double x)
{
    return x - std::floor(x);
}

/// Unit vector perpendicular to the direction, along the longest projected edge of a box of this size. This makes the
/// rectangle around the projection of the box nearly as small as possible.
Vec3 axis_across(Vec3 direction, Vec3 size)
{
    Vec3 longest;
    for (const Vec3 axis : {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}}) {
        const Vec3 edge = dot(axis, size) * axis;
        const Vec3 seen = edge - dot(edge, direction) * direction;
        if (dot(seen, seen) > dot(longest, longest))
            longest = seen;
    }
    return normalized(longest);
}

} // namespace

Bundle::Bundle(const Bounds& box, const Item& item, std::uint64_t lines)
    : direction_(square_to_uniform_sphere(item[0], item[1])), shift_u_(item[2]), shift_v_(item[3])
{
    const Vec3 half = 0.5 * box.size();
    along_u_ = axis_across(direction_, half);
    along_v_ = cross(direction_, along_u_);
    const auto reach = [&](Vec3 axis) {
        return std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z;
    };
    half_u_ = reach(along_u_);
    half_v_ = reach(along_v_);
    centre_ = box.centre() - 1.1 * reach(direction_) * direction_;
    const Vec3 d = direction_;
    const double shadow =
        4.0 * (std::abs(d.x) * half.y * half.z + std::abs(d.y) * half.z * half.x + std::abs(d.z) * half.x * half.y);
    const double rectangle = 4.0 * half_u_ * half_v_;
    constexpr double most_missing = 8.0; // limits the lines per line that meets the box, for a flat box seen edge-on
    const double ratio = shadow > 0.0 ? std::min(most_missing, rectangle / shadow) : most_missing;
    count_ = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(static_cast<double>(lines) * ratio)));
    section_ = rectangle / static_cast<double>(count_);
}

Line Bundle::line(std::uint64_t k) const
{
    constexpr double golden = 0.61803398874989485;
    const auto number = static_cast<double>(k);
    const double u = wrapped((number + 0.5) / static_cast<double>(count_) + shift_u_);
    const double v = wrapped(number * golden + shift_v_);
    return {centre_ + (2.0 * u - 1.0) * half_u_ * along_u_ + (2.0 * v - 1.0) * half_v_ * along_v_, direction_};
}

namespace {

constexpr std::uint64_t lines_together = 1024;
constexpr std::uint64_t fewest_directions = 16;

/// Segments of the lines of some successive directions.
struct BundleBlock
{
    struct Direction
    {
        double section;  ///< [m^2] represented by each line
        std::size_t end; ///< one past its last segment
    };

    std::vector<Item> items;
    std::vector<Segment> segments;
    std::vector<Direction> directions;

    void trace(const Scene& scene, std::uint64_t lines_per_direction)
    {
        segments.clear();
        directions.clear();
        for (const Item& item : items) {
            const Bundle bundle(scene.bounds(), item, lines_per_direction);
            for (std::uint64_t first = 0; first < bundle.count(); first += lines_together) {
                lines_.clear();
                for (std::uint64_t k = first; k < std::min(bundle.count(), first + lines_together); ++k)
                    lines_.push_back(bundle.line(k));
                scene.intersector().all_hits(lines_.data(), lines_.size(), hits_);
                for (std::size_t k = 0; k < lines_.size(); ++k)
                    append_segments(scene, hits_[k], segments);
            }
            directions.push_back({bundle.section(), segments.size()});
        }
    }

private:
    std::vector<Line> lines_;
    HitLists hits_;
};

/// The directions of one iteration.
struct BundleStage
{
    using Block = BundleBlock;

    Blocks lines() const { return {directions, std::max<std::uint64_t>(1, lines_together / bundle)}; }
    void trace(std::uint64_t number, BundleBlock& block) const
    {
        block.items.resize(lines().length(number));
        sequence.generate(first_item + lines().first(number), block.items);
        block.trace(scene, bundle);
    }
    std::uint64_t take(std::uint64_t number, const BundleBlock& block)
    {
        std::size_t k = 0;
        for (const BundleBlock::Direction& direction : block.directions)
            for (; k < direction.end; ++k) {
                const auto [from, to] = block.segments[k];
                send(from, to, direction.section); // (P1)
                send(to, from, direction.section);
            }
        return bundle * lines().length(number);
    }
    void send(std::uint32_t from, std::uint32_t to, double section)
    {
        if (Segment::is_patch(from))
            transfer.deposit(to, power_along_line(radiosity[from], section, directions));
    }
    void visit(Archive& archive) { transfer.visit(archive); }

    const Scene& scene;
    const Sequence& sequence;
    const std::uint64_t first_item;
    const std::uint64_t bundle; ///< lines per direction
    const std::uint64_t directions;
    const std::vector<Rgb> radiosity; ///< [W/m^2] that the lines carry
    TransportEstimate transfer;
};

} // namespace

std::uint64_t estimate_by_rays(Run& run)
{
    const std::uint64_t lines = run.solution.global_lines;
    return send_series(run, std::max<std::uint64_t>(1, lines / 8), std::max<std::uint64_t>(1, lines / 2), true);
}

BundlePlan plan_bundles(const Run& run, std::uint64_t rays)
{
    const std::uint64_t lines = run.solution.global_lines - std::min(run.solution.global_lines, rays);
    const std::uint64_t root =
        std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::sqrt(static_cast<double>(lines))));
    const std::uint64_t bundle =
        std::clamp<std::uint64_t>(lines / fewest_directions, 1, run.options.bundle.value_or(root));
    return {bundle, lines / bundle};
}

Rgb power_along_line(Rgb radiosity, double section, std::uint64_t directions)
{
    return (2.0 * section / static_cast<double>(directions)) * radiosity;
}

void bundle_iterations(Run& run)
{
    run.plan_global_lines();
    const RunControl control = run.control(1, 1);
    const Scene& scene = run.scene;
    PowerState start = run.state;
    std::uint64_t rays = 0; // of the first estimate
    const Checkpoint::Part first(control.checkpoint, "first estimate", [&](Archive& archive) {
        archive.value<std::uint64_t>("rays", rays);
        archive.object("start", start);
    });
    if (rays == 0)
        rays = estimate_by_rays(run);
    JacobiIterations iterations(scene, start, run.state, static_cast<double>(rays));
    std::uint64_t done = 0; // directions of the finished iterations
    const Checkpoint::Part part(control.checkpoint, "iterations", [&](Archive& archive) {
        archive.value<std::uint64_t>("directions", done);
        iterations.visit(archive);
    });
    const BundlePlan plan = plan_bundles(run, rays);
    while (rays > 0 && done < plan.directions && !run.stopped()) {
        const std::uint64_t left = plan.directions - done;
        const std::uint64_t lines = iterations.next_lines(left * plan.bundle);
        std::vector<Rgb> radiosity = iterations.power();
        for (std::uint32_t i = 0; i < radiosity.size(); ++i)
            radiosity[i] = (1.0 / scene.area(i)) * radiosity[i];
        BundleStage stage{scene,
                          *run.sequence,
                          run.next_item() + rays + done,
                          plan.bundle,
                          std::clamp<std::uint64_t>(lines / plan.bundle, 1, left),
                          std::move(radiosity),
                          TransportEstimate::none(scene)};
        if (run_stage("bundles", stage, control) < stage.directions)
            break;
        iterations.add(stage.transfer, static_cast<double>(stage.directions * plan.bundle));
        done += stage.directions;
    }
    if (done > 0)
        run.state = iterations.finish();
    run.solution.global_lines = run.solution.global_lines_cast = rays + done * plan.bundle;
    run.solved = true;
}

} // namespace multipath
