// Threads trace blocks of rays; the receivers are counted in the order of the rays, so that the result does not depend
// on the number of threads.

#include "radiosity/paper/shot_rays.h"

#include "base/errors.h"
#include "base/memory.h"
#include "transport/lines/line_segments.h"

#include <algorithm>

namespace multipath {

void ReceivedRays::add(const std::vector<std::uint32_t>& receivers, std::size_t first, std::size_t end,
                       const PowerState& state)
{
    for (std::size_t k = first; k < end; ++k) {
        if (k + prefetch_distance < receivers.size())
            fetch(receivers[k + prefetch_distance], state);
        add(receivers[k]);
    }
}

void ReceivedRays::fetch(std::uint32_t receiver, const PowerState& state) const
{
    if (!Segment::is_patch(receiver))
        return;
    prefetch(&counts_[receiver]);
    prefetch(&state.incident[receiver]);
    prefetch(&state.unshot[receiver]);
}

void ReceivedRays::add(std::uint32_t receiver)
{
    if (receiver == Segment::behind)
        ++behind_;
    else if (receiver == Segment::outside)
        ++outside_;
    else if (counts_[receiver]++ == 0)
        touched_.push_back(receiver);
}

void ReceivedRays::deposit(const Shot& shot, PowerState& state)
{
    for (const std::uint32_t receiver : touched_) { // (S1)
        const Rgb power = static_cast<double>(counts_[receiver]) * shot.power_per_ray;
        state.incident[receiver] += power;
        state.unshot[receiver] += scene_.reflectance(receiver) * power;
        counts_[receiver] = 0;
    }
    state.behind += static_cast<double>(behind_) * shot.power_per_ray;
    state.escaped += static_cast<double>(outside_) * shot.power_per_ray;
    touched_.clear();
    behind_ = outside_ = 0;
}

void ReceivedRays::visit(Archive& archive)
{
    archive.list<std::uint64_t>("receivers", counts_);
    archive.value<std::uint64_t>("behind", behind_);
    archive.value<std::uint64_t>("outside", outside_);
    if (archive.reads())
        for (std::uint32_t i = 0; i < counts_.size(); ++i)
            if (counts_[i] > 0)
                touched_.push_back(i);
}

namespace {

std::vector<std::uint64_t> rays_before(const std::vector<Shot>& shots)
{
    std::vector<std::uint64_t> before = {0};
    for (const Shot& shot : shots)
        before.push_back(before.back() + shot.rays);
    return before;
}

} // namespace

ShotRays::ShotRays(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                   const std::vector<Shot>& shots, PowerState& state)
    : scene_(scene),
      sequence_(sequence),
      first_item_(first_item),
      shots_(shots),
      before_(rays_before(shots)),
      state_(state),
      received_(scene)
{
}

Blocks ShotRays::lines() const
{
    return {before_.back(), rays_per_block};
}

std::size_t ShotRays::shot_of_ray(std::uint64_t ray) const
{
    return static_cast<std::size_t>(std::upper_bound(before_.begin(), before_.end(), ray) - before_.begin()) - 1;
}

void ShotRays::trace(std::uint64_t number, RayBlock& block) const
{
    const std::uint64_t first = lines().first(number);
    block.items.resize(lines().length(number));
    sequence_.generate(first_item_ + first, block.items);
    block.patches.clear();
    for (std::size_t shot = shot_of_ray(first); block.patches.size() < block.items.size(); ++shot) {
        const std::uint64_t end = std::min(before_[shot + 1] - first, std::uint64_t{block.items.size()});
        block.patches.resize(static_cast<std::size_t>(end), shots_[shot].patch);
    }
    block.trace(scene_);
}

std::uint64_t ShotRays::take(std::uint64_t number, const RayBlock& block)
{
    const std::uint64_t first = lines().first(number);
    const std::uint64_t end = first + block.receivers.size();
    for (std::uint64_t ray = first; ray < end;) {
        if (ray >= before_[shot_ + 1]) {
            received_.deposit(shots_[shot_], state_);
            shot_ = shot_of_ray(ray);
        }
        const std::uint64_t end_of_shot = std::min(end, before_[shot_ + 1]);
        received_.add(block.receivers, static_cast<std::size_t>(ray - first),
                      static_cast<std::size_t>(end_of_shot - first), state_);
        ray = end_of_shot;
    }
    return block.receivers.size();
}

void ShotRays::finish()
{
    if (!shots_.empty())
        received_.deposit(shots_[shot_], state_);
}

void ShotRays::visit(Archive& archive)
{
    archive.value<std::uint64_t>("current shot", shot_);
    received_.visit(archive);
    if (!shots_.empty() && shot_ >= shots_.size())
        throw ArchiveError("the state is damaged: no such rays");
    const Archive::Inner inner(archive, "state");
    state_.visit(archive);
}

} // namespace multipath
