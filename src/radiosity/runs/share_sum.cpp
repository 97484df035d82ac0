#include "radiosity/runs/share_sum.h"

#include "parallel/blocks.h"
#include "transport/exchange/exchange_estimate.h"
#include "transport/exchange/line_counts.h"
#include "transport/exchange/pair_counts.h"

#include <algorithm>

namespace multipath {

namespace {

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

void add_up_line_counts(const std::vector<Archive*>& shares, std::uint32_t patches, std::size_t byte_limit, int threads,
                        Archive& sum)
{
    LineCounts counts(patches, byte_limit);
    std::vector<SharedRange> ranges(shares.size());
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const Archive::Inner inner(*shares[k], "line counts");
        LineCounts share(patches);
        ranges[k].visit(*shares[k]);
        share.visit(*shares[k]);
        counts.add(share, threads);
        if (counts.full()) // one run alone would solve for these counts and begin new ones
            throw ArchiveError("the counts of all shares together fill their --memory; expected shares made with more");
    }
    const Archive::Inner inner(sum, "line counts");
    SharedRange whole = united(ranges);
    whole.visit(sum);
    counts.visit(sum);
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
                   std::size_t byte_limit, int threads, Archive& sum)
{
    const std::string stage = parts.empty() ? "" : parts.back();
    if (stage == "pair counts")
        add_up_pair_counts(shares, patches, sum);
    else if (stage == "line counts")
        add_up_line_counts(shares, patches, byte_limit, threads, sum);
    else if (stage == "pair rays")
        join_rows(shares, patches, sum);
    else
        throw ArchiveError("the shares are not finished; expected shares whose runs ended by themselves");
}

} // namespace multipath
