#include "radiosity/runs/share_sum.h"

#include "parallel/blocks.h"
#include "radiosity/reuse/gathered_light.h"
#include "transport/exchange/exchange_estimate.h"
#include "transport/exchange/line_counts.h"
#include "transport/exchange/pair_counts.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace multipath {

namespace {

template <class Value>
void visit_inner(Archive& archive, std::string_view name, Value& value)
{
    const Archive::Inner inner(archive, std::string(name));
    value.visit(archive);
}

void add_up_pair_counts(const std::vector<Archive*>& shares, std::uint32_t patches, Archive& sum)
{
    PairCounts counts(patches);
    PairCounts share(patches);
    std::vector<SharedRange> ranges(shares.size());
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const Archive::Inner inner(*shares[k], "pair counts");
        ranges[k].visit(*shares[k]);
        share.visit(*shares[k]);
        counts += share;
    }
    const Archive::Inner inner(sum, "pair counts");
    SharedRange whole = united(ranges);
    whole.visit(sum);
    counts.visit(sum);
}

/// The patches of each share have its rays to the lights; counts of rays over the hemisphere add up.
void join_rays(const std::vector<Archive*>& shares, std::uint32_t patches, int threads, Archive& sum)
{
    LineCounts counts(patches);
    std::vector<ShadowRaySums> sights;
    std::vector<SharedRange> light_ranges(shares.size());
    std::vector<SharedRange> hemisphere_ranges(shares.size());
    const Blocks blocks = GatheredLight::blocks(patches);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const Archive::Inner inner(*shares[k], "balanced reuse");
        visit_inner(*shares[k], "to lights", light_ranges[k]);
        visit_inner(*shares[k], "hemisphere", hemisphere_ranges[k]);
        std::vector<ShadowRaySums> share;
        shares[k]->growing_list<double>("sights", share);
        if (k == 0)
            sights = share;
        if (share.size() != sights.size() || light_ranges[k].end > blocks.count())
            throw ArchiveError("the shares do not fit together; expected all shares of one run");
        for (std::uint64_t i = blocks.first(light_ranges[k].first); i < blocks.first(light_ranges[k].end); ++i)
            if (i < share.size()) // none if the light of the sources was sent before
                sights[i] = share[i];
        LineCounts share_counts(patches);
        visit_inner(*shares[k], "fresh counts", share_counts);
        counts.add(std::move(share_counts), threads);
    }
    const Archive::Inner inner(sum, "balanced reuse");
    SharedRange whole = united(light_ranges);
    visit_inner(sum, "to lights", whole);
    whole = united(hemisphere_ranges);
    visit_inner(sum, "hemisphere", whole);
    sum.growing_list<double>("sights", sights);
    visit_inner(sum, "fresh counts", counts);
}

/// Each share has refined its rows; the others are as they were.
void join_rows(const std::vector<Archive*>& shares, std::uint32_t patches, Archive& sum)
{
    ExchangeEstimate all{PairMatrix<float>(patches), PairMatrix<float>(patches)};
    ExchangeEstimate share{PairMatrix<float>(patches), PairMatrix<float>(patches)};
    std::vector<SharedRange> ranges(shares.size());
    for (std::size_t k = 0; k < shares.size(); ++k) {
        {
            const Archive::Inner inner(*shares[k], "pair rays");
            ranges[k].visit(*shares[k]);
        }
        const Archive::Inner inner(*shares[k], "line reuse");
        share.exchange.visit<float>(*shares[k], "exchange");
        share.variance.visit<float>(*shares[k], "variance");
        const std::uint64_t end = std::min<std::uint64_t>(ranges[k].end, patches);
        for (auto i = static_cast<std::uint32_t>(std::min<std::uint64_t>(ranges[k].first, end)); i < end; ++i) {
            std::copy_n(share.exchange.row(i), i + 1, all.exchange.row(i));
            std::copy_n(share.variance.row(i), i + 1, all.variance.row(i));
        }
    }
    {
        const Archive::Inner inner(sum, "line reuse");
        all.exchange.visit<float>(sum, "exchange");
        all.variance.visit<float>(sum, "variance");
    }
    const Archive::Inner inner(sum, "pair rays");
    SharedRange whole = united(ranges);
    whole.visit(sum);
}

} // namespace

void add_up_shares(const std::vector<Archive*>& shares, const std::vector<std::string>& parts, std::uint32_t patches,
                   int threads, Archive& sum)
{
    const std::string stage = parts.empty() ? "" : parts.back();
    if (stage == "pair counts")
        add_up_pair_counts(shares, patches, sum);
    else if (stage == "balanced reuse")
        join_rays(shares, patches, threads, sum);
    else if (stage == "pair rays")
        join_rows(shares, patches, sum);
    else
        throw ArchiveError("the shares are not finished; expected shares whose runs ended by themselves");
}

} // namespace multipath
