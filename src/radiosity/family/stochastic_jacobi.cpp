// Both algorithms cast rays from all patches in proportion to the power that they send, and differ in what they send:
// send_series() the unshot power, pass by pass, ray_iterations() all power in every iteration. RayPlan distributes all
// rays over the patches, and RayStage traces those of one pass or iteration.

#include "radiosity/family/stochastic_jacobi.h"

#include "base/lists.h"
#include "parallel/stage.h"
#include "sampling/allotment.h"
#include "sampling/random.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace multipath {

void TransportEstimate::deposit(std::uint32_t where, Rgb power)
{
    if (where == Segment::behind)
        behind += power;
    else if (where == Segment::outside)
        escaped += power;
    else
        incident[where] += power;
}

void TransportEstimate::visit(Archive& archive)
{
    archive.list<double>("received", incident);
    archive.value<double>("escaped", escaped);
    archive.value<double>("behind", behind);
}

JacobiIterations::JacobiIterations(const Scene& scene, const PowerState& start, const PowerState& first, double lines)
    : scene_(scene),
      start_(start),
      mean_{first.incident, first.escaped - start.escaped, first.behind - start.behind},
      lines_(lines)
{
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        mean_.incident[i] = mean_.incident[i] - start.incident[i];
}

std::vector<Rgb> JacobiIterations::power() const
{
    return serial_list(scene_.patch_count(), [this](std::uint32_t i) {
        return start_.unshot[i] + scene_.reflectance(i) * mean_.incident[i];
    });
}

std::uint64_t JacobiIterations::next_lines(std::uint64_t left) const
{
    const auto as_before = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(lines_));
    return left < 2 * as_before ? left : as_before;
}

void JacobiIterations::add(const TransportEstimate& transfer, double lines)
{
    const double share = lines / (lines_ + lines);
    const auto take = [share](Rgb& mean, Rgb value) { mean = (1.0 - share) * mean + share * value; };
    for (std::size_t i = 0; i < mean_.incident.size(); ++i)
        take(mean_.incident[i], transfer.incident[i]);
    take(mean_.escaped, transfer.escaped);
    take(mean_.behind, transfer.behind);
    lines_ += lines;
}

PowerState JacobiIterations::finish() const
{
    PowerState state = start_;
    Rgb sources;
    Rgb absorbed;
    for (std::uint32_t i = 0; i < scene_.patch_count(); ++i) {
        sources += start_.unshot[i];
        absorbed += (Rgb{1.0, 1.0, 1.0} - scene_.reflectance(i)) * mean_.incident[i];
        state.incident[i] += mean_.incident[i];
        state.unshot[i] = {};
    }
    settle_losses(sources, absorbed, mean_.escaped, mean_.behind, state);
    return state;
}

void JacobiIterations::visit(Archive& archive)
{
    mean_.visit(archive);
    archive.value<double>("lines", lines_);
}

namespace {

/// Scales the values to the sum 1. Returns false if all are 0.
bool normalise(std::vector<double>& shares)
{
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    if (!(sum > 0.0))
        return false;
    for (double& share : shares)
        share *= 1.0 / sum;
    return true;
}

/// Fraction of the rays for each patch, in proportion to the power that it sends (mean of the channels). Since this
/// power is not well known, the fraction `unknown` of the rays is distributed by area times reflectance instead
/// (defensive importance sampling, Hesterberg 1995).
std::vector<double> shares_of_rays(const Scene& scene, const std::vector<Rgb>& power, double unknown)
{
    std::vector<double> shares;
    std::vector<double> reflecting;
    for (std::uint32_t i = 0; i < power.size(); ++i) {
        shares.push_back(mean(power[i]));
        reflecting.push_back(scene.area(i) * mean(scene.reflectance(i)));
    }
    normalise(shares);
    if (normalise(reflecting))
        for (std::size_t i = 0; i < shares.size(); ++i)
            shares[i] = (1.0 - unknown) * shares[i] + unknown * reflecting[i];
    return shares;
}

/// The rays of a patch in all iterations. They have consecutive items, so that together they are evenly spread.
struct PlannedRays
{
    double expected;
    double offset; ///< of the rounding, uniform in [0, 1)
    std::uint64_t first_item;

    /// Number of the rays in the first fraction `part` of all iterations, by systematic sampling in time.
    std::uint64_t before(double part) const { return whole_part(offset + part * expected); }
};

using RayPlan = std::vector<PlannedRays>; ///< per patch

/// Distributes the rays of all iterations over the patches by systematic sampling that starts at `offset`.
RayPlan plan_rays(const std::vector<double>& shares, double rays, double offset)
{
    RayPlan plan;
    double before = offset;
    for (const double share : shares) {
        plan.push_back({rays * share, before - std::floor(before), whole_part(before)});
        before += rays * share;
    }
    return plan;
}

/// What a patch sends: its radiosity, and the density of the rays that leave it.
struct Sender
{
    Rgb radiosity;            ///< [W/m^2]
    double density = 0.0;     ///< [1/m^2]
    bool is_rare = false;     ///< casts less than one ray an iteration on the mean, of several iterations
    std::uint64_t first_item; ///< of its rays, counted from the first item of the iterations
};

/// The rays of a pass or iteration, and the power that they have carried.
struct RayStage
{
    struct Block
    {
        RayBlock rays;
        std::vector<Item> items; ///< of one patch
    };

    /// The rays of the plan between the fractions `part` and `end_part`. `power` [W]: what each patch sends.
    RayStage(const Run& run, std::uint64_t first, bool both_ways, const RayPlan& plan, const std::vector<Rgb>& power,
             double part, double end_part)
        : scene(run.scene),
          sequence(*run.sequence),
          first_item(first),
          bidirectional(both_ways),
          transfer(TransportEstimate::none(run.scene))
    {
        for (std::uint32_t i = 0; i < power.size(); ++i) {
            const std::uint64_t before = plan[i].before(part);
            const std::uint64_t count = plan[i].before(end_part) - before;
            // A patch with less than one ray on the average weights it by the expected number.
            const double expected = (end_part - part) * plan[i].expected;
            rays.append(count);
            senders.push_back({(1.0 / scene.area(i)) * power[i],
                               (expected < 1.0 ? expected : static_cast<double>(count)) / scene.area(i),
                               expected < 1.0 && end_part - part < 1.0, plan[i].first_item + before});
        }
    }

    Blocks lines() const { return {rays.rays(), rays_per_block}; }
    void trace(std::uint64_t number, Block& block) const
    {
        trace_range(lines().first(number), lines().length(number), block);
    }
    void trace_range(std::uint64_t first, std::uint64_t count, Block& block) const
    {
        block.rays.patches.clear();
        block.rays.items.clear();
        rays.for_range(first, count, [&](std::uint32_t patch, std::uint64_t ray, std::size_t number) {
            block.items.resize(number);
            sequence.generate(item(patch, ray), block.items);
            block.rays.patches.insert(block.rays.patches.end(), number, patch);
            block.rays.items.insert(block.rays.items.end(), block.items.begin(), block.items.end());
        });
        block.rays.trace(scene);
    }
    std::uint64_t take(std::uint64_t number, const Block& block)
    {
        for (std::size_t k = 0; k < block.rays.receivers.size(); ++k) {
            const IterationRay ray = carried(block.rays.patches[k], block.rays.receivers[k]);
            transfer.deposit(ray.to, ray.sent); // (J1) (J2)
            if (ray.to_density > 0.0)
                transfer.deposit(ray.from, ray.returned);
        }
        return lines().length(number);
    }
    void visit(Archive& archive) { transfer.visit(archive); }

    std::uint64_t item(std::uint32_t patch, std::uint64_t ray) const
    {
        return first_item + senders[patch].first_item + (ray - rays.first_ray(patch));
    }
    IterationRay carried(std::uint32_t from, std::uint32_t to) const;

    const Scene& scene;
    const Sequence& sequence;
    const std::uint64_t first_item;
    const bool bidirectional;
    Allotment rays; ///< of the patches
    std::vector<Sender> senders;
    TransportEstimate transfer;
};

/// A ray and the power that it carries. The rays that leave i have the density n_i / A_i. In both directions, a ray
/// between i and j might as well have left j, and all rays between the two must together carry what they exchange. So
/// each carries B / (n_i / A_i + n_j / A_j) (J2), the balance heuristic (Veach and Guibas 1995). The ray of a rare
/// sender carries nothing back to it: such a patch would hold light just after it has sent, and none when its next ray
/// comes, iterations later.
IterationRay RayStage::carried(std::uint32_t from, std::uint32_t to) const
{
    const Sender& sender = senders[from];
    IterationRay ray{0, from, to, sender.density, 0.0, (1.0 / sender.density) * sender.radiosity, {}}; // (J1)
    if (!bidirectional || !Segment::is_patch(to))
        return ray;
    const Sender& other = senders[to];
    const double other_density = other.is_rare ? 0.0 : other.density;       // of rays that carry back
    ray.sent = (1.0 / (sender.density + other_density)) * sender.radiosity; // (J2)
    if (!sender.is_rare) {
        ray.to_density = other.density;
        ray.returned = (1.0 / (sender.density + other.density)) * other.radiosity; // (J2)
    }
    return ray;
}

Rgb sum_of(const std::vector<Rgb>& powers)
{
    return std::accumulate(powers.begin(), powers.end(), Rgb{});
}

/// Updates the state after all patches have sent their unshot power: they hold what they reflect of the received power.
void take_transfer(const Scene& scene, const TransportEstimate& transfer, PowerState& state)
{
    state.surplus += sum_of(transfer.incident) + transfer.escaped + transfer.behind - sum_of(state.unshot);
    state.escaped += transfer.escaped;
    state.behind += transfer.behind;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        state.incident[i] += transfer.incident[i];
        state.unshot[i] = scene.reflectance(i) * transfer.incident[i];
    }
}

/// [1] Approximate number of times that the power of the sources is sent until it is absorbed.
double usual_sendings(const Scene& scene)
{
    constexpr double most = 20.0;
    return std::min(most, 1.0 / (1.0 - std::min(0.99, mean(scene.average_reflectance()))));
}

} // namespace

std::uint64_t send_series(Run& run, std::uint64_t lines, std::uint64_t most_lines, bool bidirectional)
{
    PowerState& state = run.state;
    const RunControl control = run.control(1, 1);
    double rays_per_power = static_cast<double>(lines) / usual_sendings(run.scene) / mean(sum_of(state.unshot));
    std::uint64_t passes = 0; // finished
    std::uint64_t cast = 0;   // rays of the finished passes
    const Checkpoint::Part part(control.checkpoint, "series", [&](Archive& archive) {
        archive.value<double>("rays per watt", rays_per_power);
        archive.value<std::uint64_t>("passes", passes);
        archive.value<std::uint64_t>("cast", cast);
    });
    const std::uint64_t key = random_key(RandomStream::series_rays, run.options.seed);
    for (; cast < most_lines; ++passes) {
        const double power = mean(sum_of(state.unshot));
        if (!(power > 0.0))
            break;
        // Power below that of a single ray is sent by one ray at random, or is lost (Russian roulette).
        const double wanted = std::min(rays_per_power * power, static_cast<double>(most_lines - cast));
        const RayPlan plan =
            plan_rays(shares_of_rays(run.scene, state.unshot, 0.0), wanted, bits_to_unit(random_bits(key, passes)));
        RayStage stage(run, run.next_item() + cast, bidirectional, plan, state.unshot, 0.0, 1.0);
        if (run_stage("rays", stage, control) < stage.rays.rays())
            break;
        take_transfer(run.scene, stage.transfer, state);
        cast += stage.rays.rays();
    }
    return cast;
}

void ray_series(Run& run)
{
    const std::uint64_t lines = run.options.lines;
    run.solution.local_lines += send_series(run, std::max<std::uint64_t>(1, lines / 16),
                                            std::max<std::uint64_t>(1, lines / 2), run.options.bidirectional);
}

namespace {

/// The rays of all iterations.
RayPlan plan_iterations(const Run& run, const std::vector<Rgb>& power)
{
    // After m rays, each of n_p patches has received about m / n_p of them.
    const double unknown =
        static_cast<double>(run.scene.patch_count()) / static_cast<double>(run.solution.local_lines + 1);
    const std::vector<double> shares = shares_of_rays(run.scene, power, std::clamp(unknown, 0.02, 0.5));
    const double offset = bits_to_unit(random_bits(random_key(RandomStream::jacobi_rays, run.options.seed), 0));
    return plan_rays(shares, static_cast<double>(run.lines_left()), offset);
}

/// The stage of the iteration that casts the lines done ... done + next - 1 of the plan.
RayStage iteration_stage(const Run& run, const RayPlan& plan, const std::vector<Rgb>& power, std::uint64_t done,
                         std::uint64_t next)
{
    const auto all = static_cast<double>(run.lines_left());
    return {run,
            run.next_item(),
            run.options.bidirectional,
            plan,
            power,
            static_cast<double>(done) / all,
            static_cast<double>(done + next) / all};
}

} // namespace

void ray_iterations(Run& run)
{
    const RunControl control = run.control(1, 1);
    const PowerState start(run.scene);
    JacobiIterations iterations(run.scene, start, run.state, static_cast<double>(run.solution.local_lines));
    const RayPlan plan = plan_iterations(run, iterations.power());
    std::uint64_t done = 0; // planned lines of the finished iterations
    std::uint64_t cast = 0; // rays of these; the same up to rounding
    const Checkpoint::Part part(control.checkpoint, "iterations", [&](Archive& archive) {
        archive.value<std::uint64_t>("done", done);
        archive.value<std::uint64_t>("cast", cast);
        iterations.visit(archive);
    });
    while (done < run.lines_left()) {
        const std::uint64_t next = iterations.next_lines(run.lines_left() - done);
        RayStage stage = iteration_stage(run, plan, iterations.power(), done, next);
        if (run_stage("rays", stage, control) < stage.rays.rays())
            break;
        iterations.add(stage.transfer, static_cast<double>(next));
        done += next;
        cast += stage.rays.rays();
    }
    if (done > 0)
        run.state = iterations.finish();
    run.solution.local_lines += cast;
    run.solved = true;
}

IterationTrace trace_first_iteration(const Run& run, std::uint64_t first, std::uint64_t count)
{
    const PowerState start(run.scene);
    const JacobiIterations iterations(run.scene, start, run.state, static_cast<double>(run.solution.local_lines));
    const RayPlan plan = plan_iterations(run, iterations.power());
    const RayStage stage = iteration_stage(run, plan, iterations.power(), 0, iterations.next_lines(run.lines_left()));
    IterationTrace trace{stage.rays.rays(), {}};
    first = std::min(first, trace.ray_count);
    RayStage::Block block;
    stage.trace_range(first, std::min(count, trace.ray_count - first), block);
    for (std::size_t k = 0; k < block.rays.receivers.size(); ++k) {
        trace.rays.push_back(stage.carried(block.rays.patches[k], block.rays.receivers[k]));
        trace.rays.back().item = stage.item(block.rays.patches[k], first + k);
    }
    return trace;
}

} // namespace multipath
