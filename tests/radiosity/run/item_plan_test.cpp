#include "radiosity/run/item_plan.h"

#include "base/errors.h"

#include <doctest/doctest.h>

namespace item_plan_test {

using namespace multipath;

TEST_CASE("the stages take successive items of the sequence, and none twice")
{
    const auto sequence = make_sequence("sobol", 0);
    const ItemPlan plan = plan_items(*sequence, 10, 1000, 5000);
    CHECK(plan.first_shot == 10);
    CHECK(plan.global_pass == 1010);
    CHECK(plan.end == 6010);
}

TEST_CASE("a sequence that is too short is refused before it ends")
{
    const auto sequence = make_sequence("hammersley:100", 0);
    CHECK(plan_items(*sequence, 0, 40, 60).end == 100);
    CHECK_THROWS_AS(plan_items(*sequence, 0, 40, 61), InputError);
    CHECK_THROWS_AS(plan_items(*sequence, 1, 40, 60), InputError);
    CHECK_THROWS_AS(plan_items(*sequence, 101, 0, 0), InputError);
    const auto sobol = make_sequence("sobol", 0);
    CHECK_THROWS_AS(plan_items(*sobol, ~0ull, 1, 1), InputError);
}

} // namespace item_plan_test
