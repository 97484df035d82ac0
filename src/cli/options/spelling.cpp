#include "cli/options/spelling.h"

#include "base/text_format.h"

#include <algorithm>
#include <numeric>

namespace multipath {

namespace {

/// Levenshtein's distance: fewest insertions, deletions and replacements of letters that turn one word into the other.
std::size_t edit_distance(std::string_view from, std::string_view to)
{
    std::vector<std::size_t> distances(to.size() + 1); // of the letters of `from` so far, from the first j of `to`
    std::iota(distances.begin(), distances.end(), std::size_t{0});
    for (const char letter : from) {
        std::size_t before = distances[0]++; // of one letter less of both
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t replaced = before + (letter == to[j] ? 0 : 1);
            before = distances[j + 1];
            distances[j + 1] = std::min({distances[j] + 1, before + 1, replaced});
        }
    }
    return distances.back();
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
    std::size_t smallest = std::max<std::size_t>(1, (typed.size() + 1) / 3) + 1; // a third of the letters may be wrong
    std::string nearest;
    for (const std::string& candidate : candidates) {
        const std::string wanted = bare(candidate);
        const bool unfinished = typed.size() >= 2 && wanted.compare(0, typed.size(), typed) == 0;
        if (const std::size_t distance = unfinished ? 1 : edit_distance(typed, wanted); distance < smallest) {
            smallest = distance;
            nearest = candidate;
        }
    }
    return nearest.empty() ? "" : "; did you mean " + nearest + "?";
}

} // namespace multipath
