#include "sampling/sequence.h"

#include "sampling/radical_inverse.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <set>
#include <stdexcept>
#include <string>

using namespace multipath;

TEST_CASE("radical inverses of small numbers are those found by hand")
{
    const std::array<double, 8> base_2 = {0, 1.0 / 2, 1.0 / 4, 3.0 / 4, 1.0 / 8, 5.0 / 8, 3.0 / 8, 7.0 / 8};
    const std::array<double, 10> base_3 = {0,       1.0 / 3, 2.0 / 3, 1.0 / 9, 4.0 / 9,
                                           7.0 / 9, 2.0 / 9, 5.0 / 9, 8.0 / 9, 1.0 / 27};
    for (std::uint64_t n = 0; n < base_2.size(); ++n)
        CHECK(radical_inverse(2, n) == base_2[n]);
    for (std::uint64_t n = 0; n < base_3.size(); ++n)
        CHECK(radical_inverse(3, n) == base_3[n]);
    CHECK(radical_inverse(17, 1000) == (14.0 * 289 + 7 * 17 + 3) / 4913); // 1000 = 3 * 289 + 7 * 17 + 14
    CHECK(radical_inverse(2, ~0ull) < 1.0);
    CHECK(radical_inverse(19, ~0ull) < 1.0);
}

TEST_CASE("every sequence gives the same items in blocks and one by one, all below 1")
{
    for (const char* name : {"random", "sobol", "halton", "halton:11,13,17,19"})
        for (const Pairing pairing : {Pairing::four_dimensional, Pairing::two_dimensional})
            for (const std::uint64_t first : {0ull, 1ull, 1000ull, (1ull << 40) - 3}) {
                const auto sequence = make_sequence(name, 42, pairing);
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
    for (const char* name : {"random", "sobol", "halton", "halton:11,13,17,19"}) {
        const auto sequence = make_sequence(name, 1);
        CHECK(make_sequence(sequence->name(), 1)->item(12345) == sequence->item(12345));
    }
    CHECK(make_sequence("halton", 1)->name() == "halton:2,7,3,5");
}

TEST_CASE("two successive 2-D items make one paired item")
{
    const auto points = make_sequence("halton:2,3,5,7", 0);
    const auto pairs = make_sequence("halton:2,3,5,7", 0, Pairing::two_dimensional);
    CHECK(pairs->item(3) ==
          Item{radical_inverse(2, 6), radical_inverse(3, 6), radical_inverse(2, 7), radical_inverse(3, 7)});
}

TEST_CASE("the seed chooses among random sequences and leaves the others alone")
{
    CHECK(make_sequence("random", 1)->item(5) != make_sequence("random", 2)->item(5));
    CHECK(make_sequence("sobol", 1)->item(5) == make_sequence("sobol", 2)->item(5));
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
    CHECK(mentions("halton:2,3,5", "4 numbers"));
    CHECK(mentions("halton:2,3,5,7,11", "5 Halton bases"));
    CHECK(mentions("halton:2,3,,5", "cannot read"));
    CHECK(mentions("halton:2,3,5,x", "cannot read"));
    CHECK(mentions("halton:", "cannot read"));
    CHECK(mentions("halton:99999999999999999999,3,5,7", "1000000"));
    CHECK(mentions("niederreiter", "unknown sequence"));
}
