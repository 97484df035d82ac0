#include "commands/result_difference.h"

#include "export/csv_text.h"
#include "scene/text_format.h"
#include "scene/text_words.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace multipath {

namespace {

/// Without those that tell of the command.
std::vector<std::string> result_comments(const CsvTable& table)
{
    std::vector<std::string> comments;
    for (const std::string& comment : table.comments) {
        const auto is = [&](const std::string& start) { return comment.compare(0, start.size(), start) == 0; };
        if (!is("multipath ") && !is("command: ") && !is("seed: ") && !is("scene: "))
            comments.push_back(comment);
    }
    return comments;
}

/// "then `a`, now `b`"
std::string changed_text(const std::string& then, const std::string& now)
{
    return "then " + in_quotes(then) + ", now " + in_quotes(now);
}

std::string comment_difference(const CsvTable& then, const CsvTable& now)
{
    std::vector<std::string> before = result_comments(then);
    std::vector<std::string> after = result_comments(now);
    before.resize(std::max(before.size(), after.size()));
    after.resize(before.size());
    for (std::size_t k = 0; k < before.size(); ++k)
        if (before[k] != after[k])
            return "comments differ: " + changed_text(before[k], after[k]);
    return "";
}

/// Of two numbers, to the larger of them; nothing for other texts.
std::optional<double> relative_difference(const std::string& then, const std::string& now)
{
    const std::optional<double> a = to_number(then);
    const std::optional<double> b = to_number(now);
    if (!a || !b)
        return std::nullopt;
    return *a == *b ? 0.0 : std::abs(*a - *b) / std::max(std::abs(*a), std::abs(*b));
}

/// Cells that have to be the same and are not.
struct CellDifferences
{
    std::uint64_t count = 0;
    std::string first;
    double largest = 0.0; ///< relative difference

    void add(const std::string& place, const std::string& then, const std::string& now)
    {
        if (++count == 1)
            first = place + ": " + changed_text(then, now);
        largest = std::max(largest, relative_difference(then, now).value_or(0.0));
    }
    std::string text(std::uint64_t cells) const
    {
        if (count == 0)
            return "";
        return grouped(count) + " of " + grouped(cells) + (count == 1 ? " cells differs, " : " cells differ, first ") +
               first +
               (largest > 0.0 ? format("; relative difference%s %.3g", count == 1 ? "" : " at most", largest) : "");
    }
};

std::string size_difference(const CsvTable& then, const CsvTable& now)
{
    std::vector<std::string> before = then.header.fields;
    std::vector<std::string> after = now.header.fields;
    const auto [a, b] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
    if (a != before.end() || b != after.end())
        return "other columns: " + changed_text(a == before.end() ? "" : *a, b == after.end() ? "" : *b);
    if (then.rows.size() != now.rows.size())
        return "other number of rows: then " + grouped(then.rows.size()) + ", now " + grouped(now.rows.size());
    return "";
}

ResultDifference cell_difference(const CsvTable& then, const CsvTable& now)
{
    const std::optional<std::size_t> seconds = then.find_column("seconds");
    CellDifferences differences;
    bool times = false;
    for (std::size_t r = 0; r < then.rows.size(); ++r)
        for (std::size_t c = 0; c < then.header.fields.size(); ++c) {
            const std::string& before = then.rows[r].fields[c];
            const std::string& after = now.rows[r].fields[c];
            if (before != after && seconds == c)
                times = true;
            else if (before != after)
                differences.add("line " + std::to_string(then.rows[r].line) + ", column " + then.header.fields[c],
                                before, after);
        }
    const std::string text = differences.text(then.rows.size() * then.header.fields.size());
    return {text, times && text.empty()};
}

} // namespace

ResultDifference table_difference(const std::string& then, const std::string& now, const std::string& path)
{
    const CsvTable before = parse_csv(then, path);
    const CsvTable after = parse_csv(now, "the new table");
    for (const std::string& text : {size_difference(before, after), comment_difference(before, after)})
        if (!text.empty())
            return {text, false};
    return cell_difference(before, after);
}

} // namespace multipath
