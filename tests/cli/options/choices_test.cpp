#include "base/errors.h"
#include "cli/options/choices.h"

#include <doctest/doctest.h>

namespace usage_error_test {

using namespace multipath;

TEST_CASE("a word outside the choices is refused with all of them")
{
    CHECK_NOTHROW(require_choice("--method", "local", {"local", "global"}));
    CHECK_THROWS_WITH_AS(require_choice("--method", "gobal", {"local", "global"}),
                         "--method: expected one of local, global, got 'gobal'", UsageError);
    CHECK_THROWS_WITH_AS(require_choice("--method", "photons", {"local", "global"}),
                         "--method: expected one of local, global, got 'photons'", UsageError);
}

} // namespace usage_error_test
