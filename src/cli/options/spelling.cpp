#include "cli/options/spelling.h"

#include "base/text_format.h"

#include <algorithm>
#include <string_view>

namespace multipath {

namespace {

/// Optimal string alignment distance: fewest insertions, deletions, replacements and swaps of neighbours that turn one
/// word into the other.
std::size_t edit_distance(std::string_view from, std::string_view to)
{
    // distance[i][j]: that of the first i letters of the one word from the first j of the other
    std::vector<std::vector<std::size_t>> distance(from.size() + 1, std::vector<std::size_t>(to.size() + 1));
    for (std::size_t i = 0; i <= from.size(); ++i)
        for (std::size_t j = 0; j <= to.size(); ++j) {
            std::size_t& least = distance[i][j] = i + j;
            if (i == 0 || j == 0)
                continue;
            const std::size_t replacement = from[i - 1] == to[j - 1] ? 0 : 1;
            least = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1, distance[i - 1][j - 1] + replacement});
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                least = std::min(least, distance[i - 2][j - 2] + 1);
        }
    return distance.back().back();
}

/// The word without leading dashes and in lower case: neither counts as a misspelling.
std::string bare(std::string_view word)
{
    return lower_case(word.substr(std::min(word.find_first_not_of('-'), word.size())));
}

} // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates)
{
    const std::string typed = bare(word);
    if (typed.empty())
        return "";
    std::size_t smallest = std::max<std::size_t>(1, typed.size() / 3) + 1; // at most a third of the letters wrong
    std::string nearest;
    for (const std::string& candidate : candidates) {
        const std::string wanted = bare(candidate);
        const bool unfinished = typed.size() >= 2 && wanted.compare(0, typed.size(), typed) == 0;
        const std::size_t distance =
            unfinished ? std::min<std::size_t>(1, wanted.size() - typed.size()) : edit_distance(typed, wanted);
        if (distance < smallest) {
            smallest = distance;
            nearest = candidate;
        }
    }
    return nearest.empty() ? "" : "; did you mean " + nearest + "?";
}

} // namespace multipath
