#include "cli/options/choices.h"

#include "base/errors.h"
#include "base/text_format.h"

#include <algorithm>

namespace multipath {

std::string quoted_argument(std::string_view text)
{
    return "'" + without_controls(text) + "'";
}

void require_choice(std::string_view option, std::string_view word, const std::vector<std::string_view>& choices)
{
    if (std::find(choices.begin(), choices.end(), word) != choices.end())
        return;
    throw UsageError(std::string(option) + ": expected one of " + join(choices) + ", got " + quoted_argument(word));
}

} // namespace multipath
