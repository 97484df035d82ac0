#include "export/discrepancy_table.h"

#include <doctest/doctest.h>

namespace discrepancy_table_test {

using namespace multipath;

namespace {

std::vector<DiscrepancyRow> two_rows()
{
    return {{1, 0.5, 0.25, 0.75}, {3, 1.0 / 3.0, 0.125, std::nullopt}};
}

} // namespace

TEST_CASE("the counts are powers of two and the last one")
{
    const std::unique_ptr<Sequence> sobol = make_sequence("sobol", 1, 3);
    const auto counts = [&](std::uint64_t last) {
        std::vector<std::uint64_t> result;
        for (const DiscrepancyRow& row : measure_discrepancy(*sobol, 0, last))
            result.push_back(row.count);
        return result;
    };
    CHECK(counts(1) == std::vector<std::uint64_t>{1});
    CHECK(counts(8) == std::vector<std::uint64_t>{1, 2, 4, 8});
    CHECK(counts(10) == std::vector<std::uint64_t>{1, 2, 4, 8, 10});
}

// The first N = 2^k of Sobol's points in one dimension are i/N: star discrepancy 1/N.
TEST_CASE("the rows are of the first points, in one dimension with the star discrepancy of the closed form")
{
    for (const DiscrepancyRow& row : measure_discrepancy(*make_sequence("sobol", 1, 1), 0, 64))
        CHECK(row.star.value() == doctest::Approx(1.0 / static_cast<double>(row.count)).epsilon(1e-12));
}

TEST_CASE("skipped points are not counted")
{
    const std::vector<DiscrepancyRow> rows = measure_discrepancy(*make_sequence("sobol", 1, 1), 1, 1);
    CHECK(rows[0].star.value() == 0.5); // point 1 is at 1/2
}

TEST_CASE("the table has numbers that read back exactly, and nothing where there is no number")
{
    CHECK(discrepancy_table(two_rows(), {"one"}) == "# one\ncount,l2_star,random_l2_star,star\n1,0.5,0.25,0.75\n"
                                                    "3,0.33333333333333331,0.125,\n");
}

TEST_CASE("the text is aligned, with a dash where there is no number")
{
    CHECK(discrepancy_text(two_rows()) == "   points      L2 star    if random         star\n"
                                          "        1   5.0000e-01   2.5000e-01   7.5000e-01\n"
                                          "        3   3.3333e-01   1.2500e-01            -\n");
}

} // namespace discrepancy_table_test
