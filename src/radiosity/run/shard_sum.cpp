// The shards of a run of `reuse` stop at one of three stages, each with a sum or a table in its archive that can be
// completed from the other shards: counts along global lines, rays of balanced reuse, or rows refined by pair rays.

#include "radiosity/run/shard_sum.h"

#include "base/errors.h"
#include "parallel/blocks.h"
#include "radiosity/reuse/gathered_light.h"
#include "transport/exchange/exchange_estimate.h"
#include "transport/exchange/line_counts.h"
#include "transport/exchange/pair_counts.h"

#include <algorithm>
#include <utility>

namespace multipath {

namespace {

void add_up_pair_counts(const std::vector<Archive*>& shards, std::uint32_t patches, Archive& sum)
{
    PairCounts counts(patches);
    PairCounts shard_counts(patches);
    std::vector<ShardRange> ranges;
    for (Archive* const shard : shards) {
        const Archive::Inner inner(*shard, "pair counts");
        ranges.emplace_back().visit(*shard);
        shard_counts.visit(*shard);
        counts += shard_counts;
    }
    const Archive::Inner inner(sum, "pair counts");
    union_of(ranges).visit(sum);
    counts.visit(sum);
}

/// Takes the shadow rays of each patch from the shard that cast them, and adds up the counts of rays over the
/// hemisphere.
void join_rays(const std::vector<Archive*>& shards, std::uint32_t patches, int threads, Archive& sum)
{
    LineCounts counts(patches);
    std::vector<ShadowRaySums> shadow_ray_sums;
    std::vector<ShardRange> light_ranges;
    std::vector<ShardRange> hemisphere_ranges;
    const Blocks blocks = GatheredLight::blocks(patches);
    for (Archive* const shard : shards) {
        const Archive::Inner inner(*shard, "balanced reuse");
        shard->object("to lights", light_ranges.emplace_back());
        shard->object("hemisphere", hemisphere_ranges.emplace_back());
        std::vector<ShadowRaySums> shard_sums;
        shard->optional_list<double>("sights", shard_sums);
        if (light_ranges.size() == 1)
            shadow_ray_sums = shard_sums;
        const ShardRange range = light_ranges.back();
        if (shard_sums.size() != shadow_ray_sums.size() || range.end > blocks.count())
            throw ArchiveError("the shards do not fit together; expected all shards of one run");
        for (std::uint64_t i = blocks.first(range.first); i < blocks.first(range.end); ++i)
            if (i < shard_sums.size()) // empty if the light of the sources was distributed before
                shadow_ray_sums[i] = shard_sums[i];
        LineCounts shard_counts(patches);
        shard->object("fresh counts", shard_counts);
        counts.add(std::move(shard_counts), threads);
    }
    const Archive::Inner inner(sum, "balanced reuse");
    ShardRange lights = union_of(light_ranges);
    ShardRange hemisphere = union_of(hemisphere_ranges);
    sum.object("to lights", lights);
    sum.object("hemisphere", hemisphere);
    sum.optional_list<double>("sights", shadow_ray_sums);
    sum.object("fresh counts", counts);
}

/// Takes each row from the shard that refined it.
void join_rows(const std::vector<Archive*>& shards, std::uint32_t patches, Archive& sum)
{
    ExchangeEstimate all{PairMatrix<float>(patches), PairMatrix<float>(patches)};
    ExchangeEstimate shard{PairMatrix<float>(patches), PairMatrix<float>(patches)};
    std::vector<ShardRange> ranges;
    for (Archive* const archive : shards) {
        archive->object("pair rays", ranges.emplace_back());
        archive->object("line reuse", shard);
        const std::uint64_t end = std::min<std::uint64_t>(ranges.back().end, patches);
        for (auto i = static_cast<std::uint32_t>(std::min(ranges.back().first, end)); i < end; ++i) {
            std::copy_n(shard.exchange.row(i), i + 1, all.exchange.row(i));
            std::copy_n(shard.variance.row(i), i + 1, all.variance.row(i));
        }
    }
    sum.object("line reuse", all);
    ShardRange whole = union_of(ranges);
    sum.object("pair rays", whole);
}

} // namespace

void add_up_shards(const std::vector<Archive*>& shards, const std::vector<std::string>& parts, std::uint32_t patches,
                   int threads, Archive& sum)
{
    const std::string stage = parts.empty() ? "" : parts.back();
    if (stage == "pair counts")
        add_up_pair_counts(shards, patches, sum);
    else if (stage == "balanced reuse")
        join_rays(shards, patches, threads, sum);
    else if (stage == "pair rays")
        join_rows(shards, patches, sum);
    else
        throw ArchiveError("the shards are not finished; expected shards whose runs ended by themselves");
}

} // namespace multipath
