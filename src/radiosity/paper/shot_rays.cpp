// plan_shots() divides the excess of the patches into rays of nearly equal power, spend() subtracts it from the
// patches, and shoot() lets the rays carry it to their receivers. Threads trace blocks of rays; the receivers are
// counted in the order of the rays, so that the result does not depend on the number of threads. Counting the rays of a
// shot first and multiplying by their power later avoids the drift of adding the same number 10^8 times.

#include "radiosity/paper/shot_rays.h"

#include "base/errors.h"
#include "parallel/stage.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

namespace multipath {

namespace {

/// The rays of all shots, in order, and how many of the current shot arrived at each receiver.
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
            if (shot != current_shot)
                deposit();
            current_shot = shot;
            const auto begin = static_cast<std::size_t>(ray - first);
            for (std::size_t k = begin; k < begin + count; ++k)
                if (const std::size_t receiver = receiver_index(block.receivers[k]); counts[receiver]++ == 0)
                    reached.push_back(receiver);
        });
        return block.receivers.size();
    }
    /// Adds the power of the counted rays to the state (S1), and resets the counts.
    void deposit()
    {
        for (const std::size_t receiver : reached) {
            const Rgb power = static_cast<double>(counts[receiver]) * shots[current_shot].power_per_ray;
            counts[receiver] = 0;
            if (receiver < scene.patch_count()) {
                state.incident[receiver] += power;
                state.unshot[receiver] += scene.reflectance(static_cast<std::uint32_t>(receiver)) * power;
            } else {
                (receiver == receiver_index(Segment::behind) ? state.behind : state.escaped) += power;
            }
        }
        reached.clear();
    }
    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("current shot", current_shot);
        archive.list<std::uint64_t>("receivers", counts);
        for (std::size_t receiver = 0; archive.reads() && receiver < counts.size(); ++receiver)
            if (counts[receiver] > 0)
                reached.push_back(receiver);
        if (current_shot >= shots.size())
            throw ArchiveError("the state is damaged: no such rays");
        archive.object("state", state);
    }
    /// Index in `counts` of a patch, Segment::behind or Segment::outside.
    std::size_t receiver_index(std::uint32_t receiver) const
    {
        return Segment::is_patch(receiver) ? receiver : scene.patch_count() + (receiver - Segment::behind);
    }

    const Scene& scene;
    const Sequence& sequence;
    const std::uint64_t first_item;
    const std::vector<Shot>& shots;
    PowerState& state;
    const Allotment rays = rays_of(shots);
    std::uint64_t current_shot = 0;        ///< the shot whose rays are being counted
    std::vector<std::size_t> reached = {}; ///< receivers with a count above zero, by their indices
    /// Of its rays, per patch, and of those that reach none.
    std::vector<std::uint64_t> counts = std::vector<std::uint64_t>(std::size_t{scene.patch_count()} + 2);
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
