#include "cli/options/choices.h"

#include "base/errors.h"

#include <algorithm>
#include <numeric>

namespace multipath {

namespace {

/// The word without leading dashes and in lower case: neither counts as a misspelling.
std::string bare(std::string_view word)
{
    word.remove_prefix(std::min(word.find_first_not_of('-'), word.size()));
    std::string result(word);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

/// Optimal string alignment distance: fewest insertions, deletions, replacements and swaps of neighbours that turn one
/// word into the other.
std::size_t edit_distance(const std::string& from, const std::string& to)
{
    std::vector<std::size_t> before_last(to.size() + 1);
    std::vector<std::size_t> last(to.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t(0));
    for (std::size_t i = 1; i <= from.size(); ++i) {
        std::vector<std::size_t> row(to.size() + 1, i);
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const bool same = from[i - 1] == to[j - 1];
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        before_last = std::move(last);
        last = std::move(row);
    }
    return last.back();
}

} // namespace

std::string quoted_argument(std::string_view text)
{
    std::string result = "'" + std::string(text) + "'";
    std::replace_if(
        result.begin(), result.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return result;
}

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

std::string listed(const std::vector<std::string_view>& words, std::string_view before_last)
{
    std::string list;
    for (std::size_t k = 0; k < words.size(); ++k)
        list.append(k == 0 ? "" : k + 1 < words.size() ? ", " : before_last).append(words[k]);
    return list;
}

void require_choice(std::string_view option, std::string_view word, const std::vector<std::string_view>& choices)
{
    if (std::find(choices.begin(), choices.end(), word) != choices.end())
        return;
    throw UsageError(std::string(option) + ": expected one of " + listed(choices) + ", got " + quoted_argument(word) +
                     did_you_mean(word, {choices.begin(), choices.end()}));
}

} // namespace multipath
