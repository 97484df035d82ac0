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
    PairCounts shard(patches);
    std::vector<ShardRange> ranges(shards.size());
    for (std::size_t k = 0; k < shards.size(); ++k) {
        const Archive::Inner inner(*shards[k], "pair counts");
        ranges[k].visit(*shards[k]);
        shard.visit(*shards[k]);
        counts += shard;
    }
    const Archive::Inner inner(sum, "pair counts");
    ShardRange whole = union_of(ranges);
    whole.visit(sum);
    counts.visit(sum);
}

/// Takes the shadow rays of each patch from the shard that cast them, and adds up the counts of rays over the
/// hemisphere.
void join_rays(const std::vector<Archive*>& shards, std::uint32_t patches, int threads, Archive& sum)
{
    LineCounts counts(patches);
    std::vector<ShadowRaySums> shadow_ray_sums;
    std::vector<ShardRange> light_ranges(shards.size());
    std::vector<ShardRange> hemisphere_ranges(shards.size());
    const Blocks blocks = GatheredLight::blocks(patches);
    for (std::size_t k = 0; k < shards.size(); ++k) {
        const Archive::Inner inner(*shards[k], "balanced reuse");
        shards[k]->object("to lights", light_ranges[k]);
        shards[k]->object("hemisphere", hemisphere_ranges[k]);
        std::vector<ShadowRaySums> shard;
        shards[k]->optional_list<double>("sights", shard);
        if (k == 0)
            shadow_ray_sums = shard;
        if (shard.size() != shadow_ray_sums.size() || light_ranges[k].end > blocks.count())
            throw ArchiveError("the shards do not fit together; expected all shards of one run");
        for (std::uint64_t i = blocks.first(light_ranges[k].first); i < blocks.first(light_ranges[k].end); ++i)
            if (i < shard.size()) // empty if the light of the sources was distributed before
                shadow_ray_sums[i] = shard[i];
        LineCounts shard_counts(patches);
        shards[k]->object("fresh counts", shard_counts);
        counts.add(std::move(shard_counts), threads);
    }
    const Archive::Inner inner(sum, "balanced reuse");
    ShardRange whole = union_of(light_ranges);
    sum.object("to lights", whole);
    whole = union_of(hemisphere_ranges);
    sum.object("hemisphere", whole);
    sum.optional_list<double>("sights", shadow_ray_sums);
    sum.object("fresh counts", counts);
}

/// Takes each row from the shard that refined it.
void join_rows(const std::vector<Archive*>& shards, std::uint32_t patches, Archive& sum)
{
    ExchangeEstimate all{PairMatrix<float>(patches), PairMatrix<float>(patches)};
    ExchangeEstimate shard{PairMatrix<float>(patches), PairMatrix<float>(patches)};
    std::vector<ShardRange> ranges(shards.size());
    for (std::size_t k = 0; k < shards.size(); ++k) {
        shards[k]->object("pair rays", ranges[k]);
        shards[k]->object("line reuse", shard);
        const std::uint64_t end = std::min<std::uint64_t>(ranges[k].end, patches);
        for (auto i = static_cast<std::uint32_t>(std::min<std::uint64_t>(ranges[k].first, end)); i < end; ++i) {
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
