// plan_shots() divides the excess of the patches into rays of nearly equal power, spend() subtracts it from the
// patches, and shoot() lets the rays carry it to their receivers. Threads trace blocks of rays; the receivers are
// counted in the order of the rays, so that the result does not depend on the number of threads. Counting the rays of a
// shot first and multiplying by their power later avoids the drift of adding the same number 10^8 times.

#include "radiosity/paper/first_shot.h"

#include "base/errors.h"
#include "base/memory.h"
#include "parallel/stage.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>

namespace multipath {

namespace {

/// The rays of all shots, in order, and how many of the present shot arrived at each receiver.
struct ShotStage
{
    using Block = RayBlock;

    Blocks lines() const { return {rays.rays(), rays_per_block}; }
    void trace(std::uint64_t number, RayBlock& block) const
    {
        const std::uint64_t first = lines().first(number);
        block.items.resize(lines().length(number));
        sequence.generate(first_item + first, block.items);
        block.patches.clear();
        rays.for_range(first, block.items.size(), [&](std::uint32_t shot, std::uint64_t, std::size_t count) {
            block.patches.insert(block.patches.end(), count, shots[shot].patch);
        });
        block.trace(scene);
    }
    std::uint64_t take(std::uint64_t number, const RayBlock& block)
    {
        const std::uint64_t first = lines().first(number);
        rays.for_range(first, block.receivers.size(), [&](std::uint32_t shot, std::uint64_t ray, std::size_t count) {
            if (shot != present)
                deposit();
            present = shot;
            const auto begin = static_cast<std::size_t>(ray - first);
            for (std::size_t k = begin; k < begin + count; ++k) {
                fetch(block.receivers[std::min(k + prefetch_distance, block.receivers.size() - 1)]);
                add(block.receivers[k]);
            }
        });
        return block.receivers.size();
    }
    /// Adds the power of the counted rays to the state (S1), and resets the counts.
    void deposit()
    {
        const Rgb power_per_ray = shots[present].power_per_ray;
        for (const std::uint32_t receiver : touched) {
            const Rgb power = static_cast<double>(counts[receiver]) * power_per_ray;
            state.incident[receiver] += power;
            state.unshot[receiver] += scene.reflectance(receiver) * power;
            counts[receiver] = 0;
        }
        state.behind += static_cast<double>(behind) * power_per_ray;
        state.escaped += static_cast<double>(outside) * power_per_ray;
        touched.clear();
        behind = outside = 0;
    }
    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("current shot", present);
        archive.list<std::uint64_t>("receivers", counts);
        archive.value<std::uint64_t>("behind", behind);
        archive.value<std::uint64_t>("outside", outside);
        if (archive.reads())
            for (std::uint32_t i = 0; i < counts.size(); ++i)
                if (counts[i] > 0)
                    touched.push_back(i);
        if (present >= shots.size())
            throw ArchiveError("the state is damaged: no such rays");
        archive.object("state", state);
    }

    void fetch(std::uint32_t receiver) const
    {
        if (!Segment::is_patch(receiver))
            return;
        prefetch(&counts[receiver]);
        prefetch(&state.incident[receiver]);
        prefetch(&state.unshot[receiver]);
    }
    void add(std::uint32_t receiver)
    {
        if (receiver == Segment::behind)
            ++behind;
        else if (receiver == Segment::outside)
            ++outside;
        else if (counts[receiver]++ == 0)
            touched.push_back(receiver);
    }

    const Scene& scene;
    const Sequence& sequence;
    const std::uint64_t first_item;
    const std::vector<Shot>& shots;
    PowerState& state;
    const Allotment rays = rays_of(shots);
    std::uint64_t present = 0; ///< the shot whose rays are being counted
    std::vector<std::uint64_t> counts = std::vector<std::uint64_t>(scene.patch_count()); ///< of its rays, per patch
    std::vector<std::uint32_t> touched = {}; ///< patches with a count above zero
    std::uint64_t behind = 0;
    std::uint64_t outside = 0;
};

} // namespace

std::uint64_t shoot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                    const std::vector<Shot>& shots, const RunControl& run, PowerState& state)
{
    if (shots.empty())
        return 0;
    ShotStage stage{scene, sequence, first_item, shots, state};
    const std::uint64_t sent = run_stage("shots", stage, run); // (S1)
    stage.deposit();
    keep_unsent(shots, sent, state);
    return stage.rays.rays();
}

} // namespace multipath
