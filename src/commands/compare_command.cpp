// The command `compare` measures the error of a result A against a reference B. If both have the same patches, the
// radiosities are compared patch by patch. If both are states of the same surfaces with different patches, or there is
// only A, what smooth shading shows of A is compared at sample points with light gathered from B or A
// (refinement/shown_error.h).

#include "base/errors.h"
#include "base/text_format.h"
#include "cli/files/standard_streams.h"
#include "cli/options/number_text.h"
#include "commands/commands.h"
#include "commands/options/scene_options.h"
#include "commands/solve/saved_run.h"
#include "export/csv_text.h"
#include "export/json.h"
#include "export/patch_table.h"
#include "radiosity/run/statistics.h"
#include "refinement/shown_error.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

namespace multipath {

namespace {

/// Error of A, the estimate, against B, the reference. Both tables have the same patches.
struct Comparison
{
    const PatchTable& a;
    const PatchTable& b;
    double area = 0.0; ///< [m^2]
    ErrorMeasure error{};
    double mean_a = 0.0; ///< radiosity [W/m^2]
    double mean_b = 0.0;

    /// [1] Root of the relative MSE.
    double root() const { return std::sqrt(error.relative_mean_square); }
};

/// Area-weighted mean [W/m^2].
double mean_radiosity(const PatchTable& table)
{
    double power = 0.0;
    double area = 0.0;
    for (std::size_t i = 0; i < table.areas.size(); ++i) {
        power += table.areas[i] * mean(table.radiosity[i]);
        area += table.areas[i];
    }
    return power / area;
}

/// Compares tables of the same patches, which must outlive the result. Throws InputError for numbers too large to
/// square, and for a reference without light.
Comparison compare(const PatchTable& a, const PatchTable& b)
{
    Comparison c{a, b};
    c.area = std::accumulate(b.areas.begin(), b.areas.end(), 0.0);
    c.mean_a = mean_radiosity(a);
    c.mean_b = mean_radiosity(b);
    c.error = measure_error(b.areas, a.radiosity, b.radiosity);
    if (!std::isfinite(c.area + c.error.mean_square + c.mean_a * c.mean_a + c.mean_b * c.mean_b))
        throw InputError(a.path + ": numbers too large to compare with " + b.path + ", expected W/m^2 and m^2");
    if (!(c.mean_b * c.mean_b > 0.0))
        throw InputError(b.path + ": mean radiosity is 0, expected a reference with light");
    return c;
}

/// The line of both reports on the mean radiosities [W/m^2].
std::string means_text(double mean_a, double mean_b)
{
    return format("radiosity  mean %.6g in A, %.6g in B W/m^2: a difference of %+.3g %%\n", mean_a, mean_b,
                  100.0 * (mean_a - mean_b) / mean_b);
}

/// The members that both reports have. `area`: [m^2]; means: radiosity [W/m^2].
JsonObject common_json(const PatchTable& a, const PatchTable& b, double area, double relative_square, double mean_a,
                       double mean_b)
{
    return JsonObject()
        .text("result", a.path)
        .text("reference", b.path)
        .count("patches", a.areas.size())
        .number("area_m2", area)
        .number("relative_mean_square_error", relative_square)
        .number("mean_radiosity", mean_a)
        .number("reference_mean_radiosity", mean_b);
}

/// The report as text.
std::string report_text(const Comparison& c)
{
    std::string text = "A          " + c.a.path + "\nB          " + c.b.path + ", the reference\n";
    text += format("patches    %s, %.6g m^2\n", grouped(c.a.areas.size()).c_str(), c.area);
    text += format("MSE        %.4g W^2/m^4; relative %.4g, its root %.4g %%\n", c.error.mean_square,
                   c.error.relative_mean_square, 100.0 * c.root());
    return text + means_text(c.mean_a, c.mean_b);
}

/// The report as the JSON object of `compare --json`.
JsonObject report_json(const Comparison& c)
{
    return common_json(c.a, c.b, c.area, c.error.relative_mean_square, c.mean_a, c.mean_b)
        .number("mean_square_error", c.error.mean_square);
}

// Results with different patches of the same surfaces are compared by what smooth shading shows at points.

/// The report as text. `alone`: there is no B.
std::string shown_text(const PatchTable& a, const PatchTable& b, const ShownError& e, bool alone)
{
    std::string text =
        "A          " + a.path + ", " + grouped(a.areas.size()) + " patches, as smooth shading shows it\n";
    text += alone ? "B          light gathered from A itself at points\n"
                  : "B          " + b.path + ", " + grouped(b.areas.size()) +
                        " patches, the reference, gathered at points\n";
    text += format("points     %s, %.6g m^2\n", grouped(e.points).c_str(), e.area);
    text += format("total      relative MSE %.3g +- %.2g, its root %.3g %%: of patches and noise together\n",
                   e.relative_mean_square, e.standard_error, 100.0 * e.root());
    return text + means_text(e.mean_shown, e.mean_true);
}

/// The report as JSON.
JsonObject shown_json(const PatchTable& a, const PatchTable& b, const ShownError& e)
{
    return common_json(a, b, e.area, e.relative_mean_square, e.mean_shown, e.mean_true)
        .count("reference_patches", b.areas.size())
        .count("points", e.points)
        .number("relative_mean_square_error_error", e.standard_error);
}

void warn_of_other_scene(const PatchTable& a, const PatchTable& b)
{
    const std::optional<std::string> scene_a = comment_value(a.comments, "scene");
    const std::optional<std::string> scene_b = comment_value(b.comments, "scene");
    if (scene_a && scene_b && *scene_a != *scene_b)
        print_note(format("warning: %s is of scene %s and %s of scene %s, although their patches have the same areas\n",
                          a.path.c_str(), scene_a->c_str(), b.path.c_str(), scene_b->c_str()));
}

int run_compare(const CommandLine& line)
{
    const std::uint64_t points = read_count("--points", line.text("points"), 1, 1ull << 30);
    std::optional<double> tolerance;
    if (line.has("tolerance"))
        tolerance = read_share("--tolerance", line.text("tolerance"));
    const bool alone = line.operands().size() == 1;
    const std::optional<ResultFile> other = alone ? std::nullopt : std::optional<ResultFile>(line.operands()[1]);
    const ResultFile result(line.operands()[0], other ? &other->table : nullptr);
    const PatchTable& a = result.table;
    if (alone && !result.scene)
        throw InputError(a.path + ": a table of patches has no surfaces, expected a state or a second result");
    const ResultFile& reference = alone ? result : *other;
    const PatchTable& b = reference.table;
    const bool json = line.has("json");
    double root = 0.0;
    if (alone || (result.scene && reference.has_other_patches(*result.scene))) {
        constexpr int rays = 512; // for each of two estimates at a point
        const int threads = thread_count(line);
        const Truth truth = gathered_truth(*reference.scene, b.radiosity, rays, threads);
        const ShownError error = shown_error(*result.scene, a.radiosity, a.radiosity, truth, points, threads);
        if (!(error.mean_true > 0.0))
            throw InputError(b.path + ": dark at all points, expected a result with light");
        root = error.root();
        print(json ? shown_json(a, b, error).document() : shown_text(a, b, error, alone));
    } else {
        require_same_patches(a, b.areas, b.path);
        warn_of_other_scene(a, b);
        const Comparison comparison = compare(a, b);
        root = comparison.root();
        print(json ? report_json(comparison).document() : report_text(comparison));
    }
    if (!tolerance || root <= *tolerance)
        return 0;
    print_note(format("multipath: %s differs by %.4g %% from %s, expected at most %.4g %%\n", a.path.c_str(),
                      100.0 * root, b.path.c_str(), 100.0 * *tolerance));
    return 1;
}

} // namespace

Command compare_command()
{
    return {
        {"compare",
         "measure the error of a result against another one of the same scene",
         {"A [B]", 1, 2},
         {{"Report",
           {{"points", 0, "N", "10000",
             "Number of points at which the shown light is compared, without B or if B has other patches."},
            {"tolerance", 0, "SHARE", "",
             "End with exit code 1 if the root of the relative mean square error exceeds this, such as 1%."},
            {"json", 0, "", "", "Print the report as JSON on standard output."},
            threads_option()}}},
         "A is measured against B, the reference: tables (solve -o FILE.csv) or states of finished runs with the "
         "same patches. A table of another program, as A, needs the columns patch, counted from 0 in the order of B, "
         "and radiosity, or radiosity_r, radiosity_g, radiosity_b.\n\n"
         "States of the same surfaces with other patches, many more in B, are compared by what smooth shading "
         "shows of A: at points, against light gathered from B, or from A itself without B. This is the error of "
         "patches and noise together, but for errors common to all that a point sees."},
        run_compare};
}

} // namespace multipath
