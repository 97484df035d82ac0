#include "base/errors.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "cli/files/output_file.h"
#include "cli/files/standard_streams.h"
#include "cli/options/number_text.h"
#include "cli/provenance.h"
#include "commands/commands.h"
#include "export/csv_text.h"
#include "export/svg/point_plots.h"
#include "sampling/discrepancy.h"
#include "sampling/sequence.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <stdexcept>

namespace multipath {

namespace {

constexpr int most_dimensions = 64;
constexpr int most_dimensions_drawn = 8;                               // 28 pairs
constexpr std::uint64_t most_points_drawn = 65536;                     // more look grey and take many megabytes
constexpr std::uint64_t most_points_measured = std::uint64_t{1} << 14; // takes seconds; quadratic in the number

constexpr std::array<NamedValue<decltype(&paper_figure_1)>, 2> paper_figures = {
    {{"1", paper_figure_1}, {"2", paper_figure_2}}};

[[noreturn]] void refuse(const std::string& option, const std::string& reason)
{
    throw UsageError(option + ": " + reason);
}

/// A range of a sequence's points.
struct PointRange
{
    std::unique_ptr<Sequence> sequence;
    std::uint64_t first;
    std::uint64_t count;
};

/// Reads the range that the options ask for, with at most so many points.
PointRange read_point_range(const CommandLine& line, std::uint64_t most)
{
    const std::uint64_t count = read_count("--count", line.text("count"), 1, most);
    const std::uint64_t first = read_count("--skip", line.text("skip"));
    const auto dimensions = static_cast<int>(read_count("--dims", line.text("dims"), 1, most_dimensions));
    const std::uint64_t seed = read_count("--seed", line.text("seed"));
    try {
        PointRange range{make_sequence(line.text("sequence"), seed, dimensions), first, count};
        const std::uint64_t limit = range.sequence->item_limit();
        if (first >= limit || count > limit - first)
            refuse("--count", range.sequence->name() + " in " + std::to_string(dimensions) + " dimensions ends after " +
                                  std::to_string(limit) + " points");
        return range;
    } catch (const std::invalid_argument& error) {
        refuse("--sequence", error.what());
    }
}

/// "sobol, points 0 to 999"
std::string range_words(const PointRange& range)
{
    return range.sequence->name() + ", points " + std::to_string(range.first) + " to " +
           std::to_string(range.first + (range.count - 1));
}

/// Writes one row per point, block by block: the table may be larger than the memory.
void write_points(OutputFile& file, const PointRange& range, const std::vector<std::string>& comments)
{
    std::string text = comment_lines(comments) + "n";
    for (int d = 0; d < range.sequence->dimensions(); ++d)
        text += ",x" + std::to_string(d);
    text += "\n";
    for (std::uint64_t n = range.first; n < range.first + range.count; ++n) {
        text += std::to_string(n);
        for (int d = 0; d < range.sequence->dimensions(); ++d)
            append_number(text += ",", range.sequence->coordinate(n, d));
        text += "\n";
        if (text.size() > 65536) {
            file.write(text);
            text.clear();
        }
    }
    file.write(text);
}

/// Discrepancy of the first `count` points.
struct DiscrepancyRow
{
    std::uint64_t count;
    double l2_star;
    double random_l2_star; ///< root mean square for independent random points
};

/// Measures the first 1, 2, 4, ... points of the range, and all of them. O(count^2).
std::vector<DiscrepancyRow> measure_discrepancy(const PointRange& range)
{
    std::vector<std::uint64_t> counts;
    for (std::uint64_t n = 1; n < range.count; n *= 2)
        counts.push_back(n);
    counts.push_back(range.count);

    return mapped(counts, [&](std::uint64_t n) -> DiscrepancyRow {
        const PointSet points = points_of(*range.sequence, range.first, n);
        return {n, l2_star_discrepancy(points), random_l2_star_discrepancy(points.size(), points.dimensions)};
    });
}

/// The table as text with aligned columns.
std::string discrepancy_text(const std::vector<DiscrepancyRow>& rows)
{
    std::string text = format("%9s%13s%13s\n", "points", "L2 star", "if random");
    for (const DiscrepancyRow& row : rows)
        text += format("%9" PRIu64 "%13.4e%13.4e\n", row.count, row.l2_star, row.random_l2_star);
    return text;
}

/// The table as CSV.
std::string discrepancy_table(const std::vector<DiscrepancyRow>& rows, const std::vector<std::string>& comments)
{
    std::string table = comment_lines(comments) + "count,l2_star,random_l2_star\n";
    for (const DiscrepancyRow& row : rows) {
        append_number(table += std::to_string(row.count) + ",", row.l2_star);
        append_number(table += ",", row.random_l2_star);
        table += "\n";
    }
    return table;
}

void require_absent(const CommandLine& line, const std::vector<std::string>& options, const std::string& reason)
{
    for (const std::string& option : options)
        if (line.has(option))
            refuse("--" + option, reason);
}

/// The output files, by default standard output.
std::vector<PlannedOutput> open(const CommandLine& line, const std::vector<std::string_view>& extensions)
{
    return open_outputs(line.has("output") ? line.all("output") : std::vector<std::string>{"-"}, {}, extensions);
}

int run_listing(const CommandLine& line)
{
    std::vector<PlannedOutput> outputs = open(line, {".csv", ".svg"});
    const bool draws = std::any_of(outputs.begin(), outputs.end(),
                                   [](const PlannedOutput& output) { return output.extension == ".svg"; });
    const PointRange range = read_point_range(line, draws ? most_points_drawn : largest_count);
    std::string drawing;
    if (draws) {
        const int dimensions = range.sequence->dimensions();
        if (dimensions < 2 || dimensions > most_dimensions_drawn)
            refuse("--dims", "a drawing takes from 2 to " + std::to_string(most_dimensions_drawn) + " dimensions");
        if (line.has("order") && range.count < 2)
            refuse("--count", "the order of points shows with two of them or more");
        const auto draw = line.has("order") ? order_plots : scatter_plots;
        drawing = draw(points_of(*range.sequence, range.first, range.count), range_words(range), provenance(line));
    } else {
        require_absent(line, {"order"}, "needs a drawing, such as -o points.svg");
    }
    for (PlannedOutput& output : outputs)
        if (output.extension == ".svg")
            output.file.write(drawing);
        else // the recorded command writes only the table: without options that need a drawing
            write_points(output.file, range, provenance(line, {"order"}));
    commit(outputs);
    return 0;
}

int run_figure(const CommandLine& line)
{
    const std::vector<std::string> fixed = {"sequence", "dims", "skip", "order", "discrepancy"};
    require_absent(line, fixed, "has no effect on a figure of the paper");
    const std::uint64_t count = read_count("--count", line.text("count"), 1, most_points_drawn);
    const std::uint64_t seed = read_count("--seed", line.text("seed"));
    std::vector<PlannedOutput> outputs = open(line, {".svg"});
    const auto figure = line.choice("figure", paper_figures).value;
    const std::string drawing = figure(count, seed, provenance(line, fixed));
    for (PlannedOutput& output : outputs)
        output.file.write(drawing);
    commit(outputs);
    return 0;
}

int run_discrepancy(const CommandLine& line)
{
    require_absent(line, {"order"}, "has no effect on --discrepancy");
    const PointRange range = read_point_range(line, most_points_measured);
    const std::vector<std::string> paths = line.all("output");
    std::vector<PlannedOutput> outputs = open_outputs(paths, {}, {".csv"});

    const std::vector<DiscrepancyRow> rows = measure_discrepancy(range);
    const std::vector<std::string> comments = provenance(line);
    for (PlannedOutput& output : outputs)
        output.file.write(discrepancy_table(rows, comments));
    commit(outputs);
    if (!is_among("-", paths))
        print(range_words(range) + format("; dimensions: %d\n\n", range.sequence->dimensions()) +
              discrepancy_text(rows));
    return 0;
}

int run_points(const CommandLine& line)
{
    if (line.has("figure"))
        return run_figure(line);
    return line.has("discrepancy") ? run_discrepancy(line) : run_listing(line);
}

} // namespace

Command points_command()
{
    return {
        {"points",
         "write or draw points of a sequence, and measure how evenly they fill space",
         {},
         {{"Output",
           {{"output", 'o', "FILE", "",
             "Output file, .csv or, for a drawing, .svg; '-' is standard output, which by default gets the points, the "
             "--figure, or a text with --discrepancy.",
             true}}},
          {"Sequence",
           {{"sequence", 's', "NAME", "sobol",
             "Sequence, such as random, sobol or halton:2,3; 'help sequences' lists them."},
            {"dims", 'd', "D", "2", "Number of dimensions."},
            {"count", 'n', "N", "1000", "Number of points."},
            {"skip", 0, "K", "0", "Leave out the first K points of the sequence."},
            {"seed", 0, "N", "1", "Seed of random and randomised sequences."}}},
          {"Drawing",
           {{"order", 0, "", "",
             "Draw arrows from each of the first points to the next, and every coordinate against the next one's."}}},
          {"Instead of points",
           {{"discrepancy", 0, "", "",
             "Measure how far the first 1, 2, 4, ... points are from uniform; 0 would be perfect."},
            {"figure", 0, "WHICH", "",
             "Draw a figure of the paper: 1, random and quasi-random points; 2, why a line should take one 4-D item.",
             false, names_of(paper_figures)}}}},
         "  multipath points --sequence sobol --dims 4 --count 1000 -o points.csv -o points.svg\n"},
        run_points};
}

} // namespace multipath
