#include "export/discrepancy_table.h"

#include "export/comments.h"
#include "sampling/discrepancy.h"
#include "scene/text/text_format.h"

#include <algorithm>
#include <array>

namespace multipath {

namespace {

std::string right_aligned(const std::string& text, std::size_t width)
{
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string text_row(const std::array<std::string, 4>& cells)
{
    return right_aligned(cells[0], 9) + right_aligned(cells[1], 13) + right_aligned(cells[2], 13) +
           right_aligned(cells[3], 13) + "\n";
}

} // namespace

std::vector<DiscrepancyRow> measure_discrepancy(const Sequence& sequence, std::uint64_t first, std::uint64_t count)
{
    std::vector<std::uint64_t> counts;
    for (std::uint64_t n = 1; n < count; n *= 2)
        counts.push_back(n);
    counts.push_back(count);

    std::vector<DiscrepancyRow> rows;
    for (const std::uint64_t n : counts) {
        const PointSet points = points_of(sequence, first, n);
        rows.push_back({n, l2_star_discrepancy(points), random_l2_star_discrepancy(points.size(), points.dimensions),
                        star_discrepancy(points)});
    }
    return rows;
}

std::string discrepancy_text(const std::vector<DiscrepancyRow>& rows)
{
    std::string text = text_row({"points", "L2 star", "if random", "star"});
    for (const DiscrepancyRow& row : rows)
        text += text_row({std::to_string(row.count), format("%.4e", row.l2_star), format("%.4e", row.random_l2_star),
                          row.star ? format("%.4e", *row.star) : "-"});
    return text;
}

std::string discrepancy_table(const std::vector<DiscrepancyRow>& rows, const std::vector<std::string>& comments)
{
    std::string table = comment_lines(comments) + "count,l2_star,random_l2_star,star\n";
    for (const DiscrepancyRow& row : rows)
        table += std::to_string(row.count) + format(",%.17g", row.l2_star) + format(",%.17g", row.random_l2_star) +
                 (row.star ? format(",%.17g", *row.star) : ",") + "\n";
    return table;
}

} // namespace multipath
