#include "sweep/scene_judge.h"

#include "base/text_format.h"
#include "radiosity/reuse/balanced_reuse.h"
#include "radiosity/reuse/line_reuse.h"
#include "radiosity/run/memory_estimate.h"
#include "radiosity/run/solve.h"
#include "statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <utility>

namespace multipath {

namespace {

struct Way
{
    const char* name;
    Method method;
    Direct direct;
    enum Memory { plenty, too_little_for_table, least } memory;
};

const std::vector<Way>& ways()
{
    static const std::vector<Way> all = {
        {"local", Method::local, Direct::gather, Way::plenty},
        {"global", Method::global, Direct::gather, Way::plenty},
        {"first-shot", Method::first_shot, Direct::gather, Way::plenty},
        {"extended", Method::extended, Direct::gather, Way::plenty},
        {"jacobi", Method::jacobi, Direct::gather, Way::plenty},
        {"transillumination", Method::transillumination, Direct::gather, Way::plenty},
        {"gathering", Method::gathering, Direct::gather, Way::plenty},
        {"reuse", Method::reuse, Direct::gather, Way::plenty},
        {"reuse after shots", Method::reuse, Direct::shoot, Way::plenty},
        {"reuse by counts", Method::reuse, Direct::gather, Way::too_little_for_table},
        {"reuse by counts after shots", Method::reuse, Direct::shoot, Way::too_little_for_table},
        {"reuse with the least memory", Method::reuse, Direct::gather, Way::least},
    };
    return all;
}

/// The patches of one material on one side.
struct Group
{
    std::string name;
    double area = 0.0;        ///< [m^2]
    double reflectance = 0.0; ///< [1]
    double emittance = 0.0;   ///< [W/m^2]
};

/// Compares the mean radiosities of the groups, for many runs.
class Judge
{
public:
    Judge(const Scene& scene, std::uint64_t lines, bool convex, std::uint64_t seed)
        : scene_(scene), lines_(lines), convex_(convex), seed_(seed), areas_(scene.areas())
    {
        std::map<std::pair<std::uint32_t, bool>, std::size_t> numbers;
        double of_sources = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const auto key = std::pair(scene.file().material[scene.surface_of(i)], scene.is_front(i));
            const auto found = numbers.insert({key, groups_.size()});
            if (found.second)
                groups_.push_back({scene.materials()[key.first].name + (key.second ? "" : ", backs")});
            group_.push_back(found.first->second);
            Group& group = groups_[group_.back()];
            group.area += areas_[i];
            group.reflectance += areas_[i] * mean(scene.reflectance(i));
            group.emittance = mean(scene.emittance(i));
            of_sources += mean(scene.first_light(i)) > 0.0 ? areas_[i] : 0.0;
        }
        for (Group& group : groups_) {
            absorbing_ += group.name == "sky" ? 0.0 : group.area - group.reflectance;
            group.reflectance /= group.area;
        }
        absorbing_ = std::max(absorbing_, 0.01 * scene.own_area());
        share_of_sources_ = of_sources / scene.total_area();
    }

    std::vector<std::string> faults()
    {
        try {
            prepare(scene_, options(ways().front()));
        } catch (const std::exception& error) { // trapped light
            return {error.what()};
        }
        for (const Way& way : ways())
            judge(way);
        return std::move(faults_);
    }

private:
    using Samples = std::vector<std::vector<double>>; ///< [W/m^2] by group and run

    SolveOptions options(const Way& way) const
    {
        SolveOptions options;
        options.method = way.method;
        options.direct = way.direct;
        options.sequence = "sobol-owen";
        options.lines = lines_;
        options.threads = 2;
        if (way.memory != Way::plenty)
            options.memory = run_bytes(static_cast<double>(scene_.surfaces().size()), scene_.patch_count()) +
                             (way.memory == Way::least ? 0.0 : 0.999 * reuse_bytes(scene_));
        return options;
    }

    void judge(const Way& way)
    {
        name_ = way.name;
        unsent_.assign(groups_.size(), 0.0);
        excess_ = variance_of_excess_ = 0.0;
        Samples samples(groups_.size());
        std::string doubt;
        try {
            const Preparation preparation = prepare(scene_, options(way));
            for (const std::size_t runs : {4u, 16u, 64u, 256u}) {
                solve_until(samples, runs, preparation, options(way), seed_ * 1000);
                doubt = doubt_about(way, preparation.unoccluded.valid(), samples, runs);
                if (doubt.empty())
                    return;
            }
        } catch (const std::exception& error) {
            doubt = error.what();
        }
        note("light", doubt);
    }

    void solve_until(Samples& samples, std::size_t runs, const Preparation& preparation, SolveOptions options,
                     std::uint64_t first_seed)
    {
        while (samples.front().size() < runs) {
            options.seed = first_seed + samples.front().size();
            const Solution solution = solve(scene_, preparation, options, [](double) {});
            check_balance(solution.balance);
            std::vector<double> power(samples.size());
            std::vector<double> unshot(samples.size());
            for (std::uint32_t i = 0; i < scene_.patch_count(); ++i) {
                const Rgb b = solution.radiosity[i];
                const Rgb e = scene_.emittance(i);
                if (!(b.r >= e.r && b.g >= e.g && b.b >= e.b && std::isfinite(mean(b))))
                    note("radiosity", format("%g of patch %u", mean(b), i));
                power[group_[i]] += areas_[i] * mean(b);
                unshot[group_[i]] += areas_[i] * std::abs(mean(solution.unshot[i]));
            }
            for (std::size_t g = 0; g < power.size(); ++g) {
                samples[g].push_back(power[g] / groups_[g].area);
                const double absorbing = std::max(0.01, 1.0 - groups_[g].reflectance) * groups_[g].area;
                unsent_[g] += std::abs(mean(solution.balance.unshot)) / absorbing_ + unshot[g] / absorbing;
            }
        }
    }

    void check_balance(const PowerBalance& balance)
    {
        const double source = mean(balance.source);
        const std::array<std::pair<const char*, Rgb>, 3> losses = {
            {{"absorbed", balance.absorbed}, {"escaped", balance.escaped}, {"behind", balance.behind}}};
        const double most = source + 5.0 * balance.emitted_error;
        for (const auto& [what, power] : losses)
            if (!(mean(power) >= -1e-9 * source && mean(power) <= (1.0 + 1e-6) * most))
                note(what, format("%g of %g W", mean(power), source));
        if (!(balance.relative_error() <= 1e-9))
            note("balance", format("open by %g", balance.relative_error()));
        const double excess = mean(balance.emitted) - source;
        if (balance.emitted_error == 0.0 && !(std::abs(excess) <= 1e-6 * source))
            note("emitted", format("%g of %g W", mean(balance.emitted), source));
        excess_ += excess;
        variance_of_excess_ += balance.emitted_error * balance.emitted_error;
    }

    /// The first material whose light differs, or nothing. The power emitted is judged by all runs, too: that of a
    /// single run has a heavy tail if few lines leave the sources.
    std::string doubt_about(const Way& way, bool has_table, const Samples& samples, std::size_t runs)
    {
        if (const double error = std::sqrt(variance_of_excess_); std::abs(excess_) > 5.0 * error && error > 0.0)
            return format("emitted by %g W too much, +- %g", excess_, error);
        if (!convex_)
            refine_truth(2 * runs);
        const bool by_particles = way.method != Method::reuse || way.direct == Direct::shoot ||
                                  lines_ < (has_table ? min_table_lines(scene_) : min_balanced_rays(scene_));
        // [1] Pairs that no line has met are guessed from those around (docs/line_reuse.md).
        const double lines_per_patch = static_cast<double>(lines_) / scene_.patch_count();
        const double guessed = 0.8 / lines_per_patch;
        // [1] Line reuse is not linear: with fewer than 32 lines per patch at once it has a bias of this order
        // (docs/line_reuse.md), and the least memory holds 24 rays of each patch.
        const double at_once =
            way.memory == Way::least ? lines_per_patch / std::ceil(lines_per_patch / 24.0) : lines_per_patch;
        const double of_few_lines = at_once < 32.0 && way.method == Method::reuse ? 0.25 / at_once : 0.0;
        const double mean_light = mean_radiosity();
        const double unseen = 2e-4 * mean_light; // light that few lines find
        for (std::size_t g = 0; g < samples.size(); ++g) {
            const Estimate found = estimate(samples[g]);
            const Estimate right = convex_ ? Estimate{closed_form(g), 0.0} : estimate(truth_[g]);
            // A bias below the noise of 16 runs passes: more of them only show that this noise was no accident.
            const double of_few = std::max(1.0, std::sqrt(static_cast<double>(runs) / 16.0));
            double noise = of_few * std::hypot(found.standard_error, right.standard_error);
            if (by_particles)
                noise = std::hypot(noise, noise_of_hits(way, g, right.mean, static_cast<double>(runs * lines_)));
            const double bias = 0.002 * right.mean + unseen +
                                std::max(has_table ? guessed : 0.0, of_few_lines) * std::max(right.mean, mean_light);
            const double unsent = unsent_[g] / static_cast<double>(runs);
            if (!(std::abs(found.mean - right.mean) <= 4.0 * noise + bias + unsent))
                return format("%s %g +- %g, not %g +- %g, %zu runs", groups_[g].name.c_str(), found.mean,
                              found.standard_error, right.mean, right.standard_error, runs);
        }
        return "";
    }

    /// [W/m^2] Over the scene without its sky, right or as it is known.
    double mean_radiosity() const
    {
        double power = 0.0;
        for (std::size_t g = 0; g < groups_.size(); ++g)
            if (groups_[g].name != "sky")
                power += groups_[g].area * (convex_ ? closed_form(g) : estimate(truth_[g]).mean);
        return power / scene_.own_area();
    }

    /// [W/m^2] The least standard deviation of light that particles bring: that of the number of those that come from
    /// the sources, or go from the patches to the sources, which may be 0 in all runs.
    double noise_of_hits(const Way& way, std::size_t g, double radiosity, double lines) const
    {
        const Group& group = groups_[g];
        const double reflected = radiosity - group.emittance;
        if (!(reflected > 0.0))
            return 0.0;
        const double received = reflected / group.reflectance * group.area / mean(scene_.source_power());
        const double crossed = group.area / scene_.total_area() * share_of_sources_;
        const double hits =
            way.method == Method::gathering ? received * share_of_sources_ : std::min(received, crossed);
        return reflected / std::sqrt(lines * hits);
    }

    /// [W/m^2] The backs of a closed body are dark.
    double closed_form(std::size_t g) const
    {
        const Group& group = groups_[g];
        const bool lit = group.name != "sky" && group.name.find("backs") == std::string::npos;
        const Rgb sky = scene_.surface_material(scene_.own_surfaces()).emittance;
        for (std::uint32_t i = 0; lit; ++i)
            if (group_[i] == g)
                return mean(scene_.reflectance(i) * sky);
        return group.emittance;
    }

    void refine_truth(std::size_t runs)
    {
        truth_.resize(groups_.size());
        SolveOptions particles = options(ways().front());
        particles.lines = std::max<std::uint64_t>(1u << 16, 2 * lines_);
        std::swap(name_, truth_name_);
        const std::vector<double> unsent = unsent_;
        solve_until(truth_, runs, {}, particles, seed_ * 1000 + 500); // emits exactly
        unsent_ = unsent;
        std::swap(name_, truth_name_);
    }

    /// Only the first fault of each kind by each method is told.
    void note(const std::string& kind, const std::string& text)
    {
        const std::string name = name_ + ": " + kind + " ";
        if (std::none_of(faults_.begin(), faults_.end(), [&](const std::string& f) { return f.rfind(name, 0) == 0; }))
            faults_.push_back(name + text);
    }

    const Scene& scene_;
    std::uint64_t lines_;
    bool convex_;
    std::uint64_t seed_;
    std::vector<double> areas_;
    std::vector<Group> groups_;
    std::vector<std::size_t> group_;  ///< by patch
    double absorbing_ = 0.0;          ///< [m^2] sum of areas times absorptances
    double share_of_sources_ = 0.0;   ///< [1] of all areas
    std::vector<double> unsent_;      ///< [W/m^2] by group, sum over the runs: about what power not sent yet would add
    double excess_ = 0.0;             ///< [W] of the power emitted, sum over the runs
    double variance_of_excess_ = 0.0; ///< [W^2]
    Samples truth_;
    std::string name_;
    std::string truth_name_ = "the particles to compare with";
    std::vector<std::string> faults_;
};

} // namespace

std::vector<std::string> faults(const Scene& scene, std::uint64_t lines, bool convex, std::uint64_t seed)
{
    return Judge(scene, lines, convex, seed).faults();
}

} // namespace multipath
