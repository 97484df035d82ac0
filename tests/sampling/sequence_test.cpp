#include "sampling/sequence.h"

#include "sampling/halton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

namespace sequence_test {

using namespace multipath;

namespace {

/// Every kind by its name alone, or with a number of points that suffices, and two with other bases.
std::vector<std::string> all_names()
{
    std::vector<std::string> names = {"halton:11,13,17,19", "halton-permuted:11,13,17,19"};
    for (const SequenceKind& kind : sequence_kinds()) {
        const bool needs_arguments = !kind.arguments.empty() && kind.arguments[0] != '[';
        names.push_back(std::string(kind.name) + (needs_arguments ? ":1000000" : ""));
    }
    return names;
}

/// Item 0, as each of many seeds makes it.
std::vector<Item> items_by_seed(const std::string& name)
{
    std::vector<Item> items;
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
        items.push_back(make_sequence(name, seed)->item(0));
    return items;
}

} // namespace

TEST_CASE("every sequence gives the same items in blocks and one by one, all below 1")
{
    for (const std::string& name : all_names())
        for (const Pairing pairing : {Pairing::four_dimensional, Pairing::two_dimensional})
            for (const std::uint64_t first : {0ull, 1ull, 1000ull, (1ull << 40) - 3}) {
                if (pairing == Pairing::two_dimensional && name.find(',') != std::string::npos)
                    continue; // four bases
                if (first + 100 > make_line_sequence(name, 42, pairing)->item_limit())
                    continue;
                const auto sequence = make_line_sequence(name, 42, pairing);
                std::vector<Item> items(100);
                sequence->generate(first, items);
                for (std::uint64_t k = 0; k < items.size(); ++k) {
                    CHECK(items[k] == sequence->item(first + k));
                    for (const double x : items[k])
                        CHECK((x >= 0.0 && x < 1.0));
                }
            }
}

TEST_CASE("a name makes the same sequence again")
{
    for (const std::string& name : all_names()) {
        const auto sequence = make_sequence(name, 1);
        CHECK(sequence->name().compare(0, name.size(), name) == 0);
        CHECK(make_sequence(sequence->name(), 1)->item(12345) == sequence->item(12345));
    }
    CHECK(make_sequence("halton", 1)->name() == "halton:2,7,3,5");
}

TEST_CASE("two successive 2-D items make one paired item")
{
    const auto pairs = make_line_sequence("halton:2,3", 0, Pairing::two_dimensional);
    CHECK(pairs->item(3) ==
          Item{radical_inverse(2, 6), radical_inverse(3, 6), radical_inverse(2, 7), radical_inverse(3, 7)});
}

// Replicates of a sequence that the seed leaves alone would be one run, and their spread nothing.
TEST_CASE("the seed chooses among the kinds that are called randomised and leaves the others alone")
{
    for (const std::string& name : all_names()) {
        CAPTURE(name);
        const auto seed_matters = [](const std::string& sequence) {
            return make_sequence(sequence, 1)->item(5) != make_sequence(sequence, 2)->item(5);
        };
        CHECK(seed_matters(name) == is_randomised(name));
        if (sequence_kind(name).randomised.empty()) {
            CHECK_THROWS_WITH_AS(randomised_name(name), doctest::Contains("another sequence"), std::invalid_argument);
            continue;
        }
        CHECK(is_randomised(name) == (randomised_name(name) == name));
        CHECK(seed_matters(randomised_name(name)));
    }
    CHECK(randomised_name("halton:2,3,5,7") == "halton-permuted:2,3,5,7");
}

// Mean and variance of a uniform number are 1/2 and 1/12; the standard errors over n numbers are sqrt(1/12n) and
// sqrt(1/180n).
TEST_CASE("random numbers are uniform and unlike their neighbours")
{
    const auto sequence = make_sequence("random", 3);
    constexpr int n = 200000;
    std::vector<Item> items(n);
    sequence->generate(0, items);
    for (std::size_t d = 0; d < 4; ++d) {
        double sum = 0.0;
        double squares = 0.0;
        double products = 0.0; // with the next item's number
        for (std::size_t k = 0; k < n; ++k) {
            const double x = items[k][d] - 0.5;
            sum += x;
            squares += x * x;
            products += x * (items[(k + 1) % n][d] - 0.5);
        }
        CHECK(std::abs(sum / n) < 4 * std::sqrt(1.0 / 12 / n));
        CHECK(std::abs(squares / n - 1.0 / 12) < 4 * std::sqrt(1.0 / 180 / n));
        CHECK(std::abs(products / n) < 4.0 / 12 / std::sqrt(1.0 * n));
    }
}

TEST_CASE("bases that cannot work are refused with the reason")
{
    const auto problem = [](const std::string& name) -> std::string {
        try {
            make_sequence(name, 0);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    const auto mentions = [&](const std::string& name, const std::string& words) {
        CAPTURE(problem(name));
        return problem(name).find(words) != std::string::npos;
    };
    CHECK(mentions("halton:4,6,5,7", "4 and 6"));
    CHECK(mentions("halton:1,2,3,5", "at least 2"));
    CHECK(mentions("halton:0,2,3,5", "at least 2"));
    CHECK(mentions("halton:2,3,5", "has 3"));
    CHECK(mentions("halton:2,3,5,7,11", "has 5"));
    CHECK(mentions("halton:2,3,,5", "cannot read"));
    CHECK(mentions("halton:2,3,5,x", "cannot read"));
    CHECK(mentions("halton:", "nothing follows"));
    CHECK(mentions("halton:9999999,3,5,7", "1000000"));
    CHECK(mentions("halton:99999999999999999999,3,5,7", "cannot read"));
    CHECK(mentions("sobol:2,3,5,7", "takes no bases"));
    CHECK(mentions("hammersley", "number of points"));
    CHECK(mentions("hammersley:0", "from 1"));
    CHECK(mentions("hammersley:10:2,3", "has 2"));
    CHECK(mentions("niederreiter", "unknown sequence"));
}

TEST_CASE("every kind of sequence is in the list of the refusal")
{
    for (const SequenceKind& kind : sequence_kinds())
        CHECK_THROWS_WITH_AS(make_sequence("niederreiter", 0), doctest::Contains(std::string(kind.name).c_str()),
                             std::invalid_argument);
}

TEST_CASE("dimensions beyond what a kind has are refused")
{
    CHECK_THROWS_WITH_AS(make_sequence("sobol", 0, 7), doctest::Contains("6 dimensions"), std::invalid_argument);
    CHECK(make_sequence("halton", 0, 12)->name() == "halton:2,3,5,7,11,13,17,19,23,29,31,37");
    CHECK(make_sequence("random", 0, 9)->dimensions() == 9);
}

// Pearson's statistic of n numbers in k equal cells has mean k - 1 and standard deviation sqrt(2 (k - 1)).
TEST_CASE("random numbers fill cells evenly, alone and in pairs of dimensions and of seeds")
{
    constexpr int n = 160000;
    constexpr int cells = 16;
    std::vector<Item> items(n);
    std::vector<Item> other_seed(n);
    make_sequence("random", 1)->generate(0, items);
    make_sequence("random", 2)->generate(0, other_seed);
    const auto chi_square = [&](const auto& x, const auto& y) {
        constexpr double expected = 1.0 * n / (cells * cells);
        std::vector<double> counts(cells * cells, 0.0);
        for (std::size_t k = 0; k < n; ++k)
            counts[static_cast<std::size_t>(x(k) * cells) * cells + static_cast<std::size_t>(y(k) * cells)] += 1.0;
        double sum = 0.0;
        for (const double count : counts)
            sum += (count - expected) * (count - expected) / expected;
        return sum;
    };
    const double mean = cells * cells - 1;
    const double tolerance = 4.0 * std::sqrt(2.0 * mean);
    for (std::size_t d = 0; d < 4; ++d) {
        const auto own = [&](std::size_t k) { return items[k][d]; };
        const auto next_dimension = [&](std::size_t k) { return items[k][(d + 1) % 4]; };
        const auto next_item = [&](std::size_t k) { return items[(k + 1) % n][d]; };
        const auto other = [&](std::size_t k) { return other_seed[k][d]; };
        CHECK(std::abs(chi_square(own, next_dimension) - mean) < tolerance);
        CHECK(std::abs(chi_square(own, next_item) - mean) < tolerance);
        CHECK(std::abs(chi_square(own, other) - mean) < tolerance);
    }
}

// Hammersley's first coordinate is n / N; the others are those of Halton's sequence.
TEST_CASE("Hammersley's points are known in number")
{
    const auto sequence = make_sequence("hammersley:8", 0, 3);
    CHECK(sequence->item_limit() == 8);
    CHECK(sequence->coordinate(3, 0) == 3.0 / 8);
    CHECK(sequence->coordinate(3, 1) == 0.75);
    CHECK(sequence->coordinate(3, 2) == 1.0 / 9);
}

// In s dimensions the steps are 1/g, 1/g^2, ... with g^(s + 1) = g + 1. In one dimension g is the golden ratio: of N
// points, no two neighbours are further apart than 2 / N.
TEST_CASE("the Kronecker sequence steps by powers of a golden ratio")
{
    for (int dimensions = 1; dimensions <= 6; ++dimensions) {
        double low = 1.0;
        double high = 2.0;
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (low + high);
            (std::pow(middle, dimensions + 1) < middle + 1.0 ? low : high) = middle;
        }
        const auto sequence = make_sequence("kronecker", 0, dimensions);
        for (int d = 0; d < dimensions; ++d) {
            CAPTURE(dimensions);
            CAPTURE(d);
            const double step = sequence->coordinate(1, d) - 0.5;
            CHECK(step + (step < 0.0 ? 1.0 : 0.0) == doctest::Approx(std::pow(low, -(d + 1))).epsilon(1e-14));
        }
    }

    const auto line = make_sequence("kronecker", 0, 1);
    std::set<double> places;
    for (std::uint64_t n = 0; n < 1000; ++n)
        places.insert(line->coordinate(n, 0));
    double widest = *places.begin() + 1.0 - *places.rbegin();
    for (auto place = places.begin(); std::next(place) != places.end(); ++place)
        widest = std::max(widest, *std::next(place) - *place);
    CHECK(widest < 2.0 / 1000);
}

// Point 0 has the digits 0, 0, ..., whose permutations the seed chooses: the first digit becomes each of the base
// equally often, and what is left beyond 2^-30 is uniform too. Binomial and uniform, 4 standard deviations.
TEST_CASE("permuted digits are uniform, first ones and those beyond the last")
{
    const std::vector<std::uint64_t> bases = {2, 3, 5, 7};
    const std::vector<Item> items = items_by_seed("halton-permuted:2,3,5,7");
    const auto seeds = static_cast<double>(items.size());
    for (std::size_t d = 0; d < 4; ++d) {
        const auto base = static_cast<double>(bases[d]);
        std::vector<double> counts(bases[d], 0.0);
        double tails = 0.0;
        for (const Item& item : items) {
            counts[static_cast<std::size_t>(base * item[d])] += 1.0;
            tails += std::ldexp(item[d], 30) - std::floor(std::ldexp(item[d], 30));
        }
        CAPTURE(base);
        for (const double count : counts)
            CHECK(std::abs(count / seeds - 1.0 / base) < 4.0 * std::sqrt((1.0 - 1.0 / base) / base / seeds));
        CHECK(std::abs(tails / seeds - 0.5) < 4.0 * std::sqrt(1.0 / 12.0 / seeds));
    }
}

// A shift that all dimensions share would move the points along the diagonal only. The correlation of independent
// numbers is normal with standard deviation 1 / sqrt(n).
TEST_CASE("the seed randomises each dimension by itself")
{
    for (const SequenceKind& kind : sequence_kinds()) {
        const std::string name(kind.name);
        if (kind.randomised != kind.name)
            continue;
        CAPTURE(name);
        const std::vector<Item> items = items_by_seed(name);
        const auto seeds = static_cast<double>(items.size());
        for (std::size_t d = 1; d < 4; ++d) {
            double products = 0.0;
            for (const Item& item : items)
                products += 12.0 * (item[0] - 0.5) * (item[d] - 0.5);
            CHECK(std::abs(products / seeds) < 4.0 / std::sqrt(seeds));
        }
    }
}

TEST_CASE("of a sequence in pairs there are half as many items")
{
    CHECK(make_line_sequence("hammersley:100", 0, Pairing::four_dimensional)->item_limit() == 100);
    CHECK(make_line_sequence("hammersley:100", 0, Pairing::two_dimensional)->item_limit() == 50);
}

TEST_CASE("blocks have the first four coordinates of sequences that have more")
{
    for (const char* name : {"random", "halton", "halton-permuted", "sobol", "sobol-owen", "kronecker"}) {
        CAPTURE(name);
        const auto sequence = make_sequence(name, 1, 6);
        std::vector<Item> items(20);
        sequence->generate(1000, items);
        for (std::uint64_t k = 0; k < items.size(); ++k)
            CHECK(items[k] == sequence->item(1000 + k));
    }
}

TEST_CASE("there may be as many points as doubles tell apart")
{
    CHECK(make_sequence("hammersley:4503599627370496", 0)->item_limit() == 1ull << 52);
    CHECK_THROWS_AS(make_sequence("hammersley:4503599627370497", 0), std::invalid_argument);
}

} // namespace sequence_test
