// Package-merge (Larmore and Hirschberg, A fast algorithm for optimal length-limited Huffman codes, JACM 1990): a code
// word of length n is bought as n coins, one of each of n denominations. The cheapest way to buy them all pairs the
// coins of one denomination into packages that compete with the coins of the next.

#include "image/huffman.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace multipath {

namespace {

/// Coins bought together: what they cost and which symbols they lengthen.
struct Package
{
    std::uint64_t cost = 0;
    std::vector<std::uint16_t> symbols;
};

std::vector<Package> coins_by_cost(const std::vector<std::uint32_t>& frequencies)
{
    std::vector<Package> coins;
    for (std::size_t symbol = 0; symbol < frequencies.size(); ++symbol)
        if (frequencies[symbol] > 0)
            coins.push_back({frequencies[symbol], {static_cast<std::uint16_t>(symbol)}});
    std::stable_sort(coins.begin(), coins.end(), [](const Package& a, const Package& b) { return a.cost < b.cost; });
    return coins;
}

/// Neighbours two by two; the last is left over if their number is odd.
std::vector<Package> paired(const std::vector<Package>& packages)
{
    std::vector<Package> pairs;
    for (std::size_t i = 0; i + 1 < packages.size(); i += 2) {
        Package pair = packages[i];
        pair.cost += packages[i + 1].cost;
        pair.symbols.insert(pair.symbols.end(), packages[i + 1].symbols.begin(), packages[i + 1].symbols.end());
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

} // namespace

std::vector<std::uint8_t> code_lengths(std::vector<std::uint32_t> frequencies, std::size_t limit)
{
    for (std::size_t symbol = 0;
         std::count(frequencies.begin(), frequencies.end(), 0u) + 2 > static_cast<std::ptrdiff_t>(frequencies.size());
         ++symbol)
        frequencies[symbol] = std::max(frequencies[symbol], 1u);

    const std::vector<Package> coins = coins_by_cost(frequencies);
    std::vector<Package> packages;
    for (std::size_t denomination = 0; denomination < limit; ++denomination) {
        std::vector<Package> merged;
        std::merge(coins.begin(), coins.end(), packages.begin(), packages.end(), std::back_inserter(merged),
                   [](const Package& a, const Package& b) { return a.cost < b.cost; });
        packages = paired(merged);
    }
    std::vector<std::uint8_t> lengths(frequencies.size(), 0);
    for (std::size_t i = 0; i + 1 < coins.size(); ++i)
        for (const std::uint16_t symbol : packages[i].symbols)
            ++lengths[symbol];
    return lengths;
}

std::vector<std::uint16_t> code_words(const std::vector<std::uint8_t>& lengths)
{
    std::vector<std::uint16_t> words(lengths.size(), 0);
    const int longest = *std::max_element(lengths.begin(), lengths.end());
    std::uint32_t next = 0;
    for (int length = 1; length <= longest; ++length, next <<= 1)
        for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol)
            if (lengths[symbol] == length) {
                std::uint32_t reversed = 0;
                for (int bit = 0; bit < length; ++bit)
                    reversed |= (next >> bit & 1u) << (length - 1 - bit);
                words[symbol] = static_cast<std::uint16_t>(reversed);
                ++next;
            }
    return words;
}

} // namespace multipath
