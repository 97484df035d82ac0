#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The text "; did you mean CANDIDATE?" with the candidate that `word` most likely misspells or begins; "" if none is
/// near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

} // namespace multipath
