#include "commands/comparison_report.h"

#include "scene/text_format.h"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace multipath {

namespace {

/// "1.8e-05 (0.426 %)"
std::string expected_text(std::optional<double> relative_square)
{
    return relative_square ? format("%.3g (%.3g %%)", *relative_square, 100.0 * std::sqrt(*relative_square))
                           : "unknown";
}

/// The MSE of a few replicates scatters by up to a factor of two.
std::string verdict(const Comparison& c, double ratio)
{
    if (ratio < 0.5)
        return "less than independent results would differ";
    if (c.expected_a && c.expected_b)
        return ratio <= 2.0 ? "they explain it" : "they do not explain it";
    const std::string one = c.expected_a ? "A" : "B";
    const std::string other = c.expected_a ? "B" : "A";
    return ratio <= 2.0 ? "that of " + one + " alone explains it" : "the rest is the unknown one of " + other;
}

std::string errors_text(const Comparison& c)
{
    if (!c.expected_a && !c.expected_b)
        return "";
    const std::string text = "errors     relative MSE by its own standard errors: A " + expected_text(c.expected_a) +
                             ", B " + expected_text(c.expected_b) + "\n";
    const std::optional<double> ratio = c.measured_over_expected();
    if (!ratio)
        return text + "explained  all standard errors are 0 and explain nothing\n";
    return text + format("explained  the MSE is %.3g times what these errors let expect: ", *ratio) +
           verdict(c, *ratio) + "\n";
}

std::string worst_text(const Comparison& c)
{
    if (c.worst.empty())
        return "";
    std::string text = format("worst    %9s %8s %12s %12s   %-27s %s\n", "patch", "of MSE", "A W/m^2", "B W/m^2",
                              "centre", "material");
    for (const WorstPatch& patch : c.worst) {
        const std::size_t i = patch.patch;
        const Vec3 centre = c.b.centres[i];
        text += format("         %9zu %6.2f %% %12.6g %12.6g   %-27s ", i, 100.0 * patch.share, mean(c.a.radiosity[i]),
                       mean(c.b.radiosity[i]), format("(%.4g, %.4g, %.4g)", centre.x, centre.y, centre.z).c_str()) +
                c.b.materials[i] + "\n";
    }
    return text;
}

JsonObject worst_json(const Comparison& c, const WorstPatch& patch)
{
    const Vec3 centre = c.b.centres[patch.patch];
    JsonObject json;
    json.count("patch", patch.patch);
    json.text("material", c.b.materials[patch.patch]);
    json.numbers("centre", {centre.x, centre.y, centre.z});
    json.number("radiosity", mean(c.a.radiosity[patch.patch]));
    json.number("reference_radiosity", mean(c.b.radiosity[patch.patch]));
    json.number("share", patch.share);
    return json;
}

} // namespace

std::string report_text(const Comparison& c)
{
    std::string text = "A          " + c.a.path + "\nB          " + c.b.path + ", the reference\n";
    text += format("patches    %s, %.6g m^2\n", grouped(c.a.areas.size()).c_str(), c.area);
    text += format("MSE        %.4g W^2/m^4; relative %.4g, its root %.4g %%\n", c.error.mean_square,
                   c.error.relative_mean_square, 100.0 * c.root());
    text += format("largest    deviation %+.4g W/m^2 in one channel of patch %zu, %.3g %% of the mean radiosity\n",
                   c.largest.value, c.largest.patch, 100.0 * std::abs(c.largest.value / c.mean_b));
    text += format("radiosity  mean %.6g in A, %.6g in B W/m^2: a difference of %+.3g %%\n", c.mean_a, c.mean_b,
                   100.0 * (c.mean_a - c.mean_b) / c.mean_b);
    return text + errors_text(c) + worst_text(c);
}

JsonObject report_json(const Comparison& c)
{
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN(); // null
    JsonObject json;
    json.text("result", c.a.path);
    json.text("reference", c.b.path);
    json.count("patches", c.a.areas.size());
    json.number("area_m2", c.area);
    json.number("mean_square_error", c.error.mean_square);
    json.number("relative_mean_square_error", c.error.relative_mean_square);
    json.number("relative_root_mean_square_error", c.root());
    json.number("largest_deviation", c.largest.value);
    json.count("largest_deviation_patch", c.largest.patch);
    json.number("mean_radiosity", c.mean_a);
    json.number("reference_mean_radiosity", c.mean_b);
    json.number("mean_radiosity_difference", (c.mean_a - c.mean_b) / c.mean_b);
    json.number("expected_relative_mean_square_error", c.expected_a.value_or(unknown));
    json.number("reference_expected_relative_mean_square_error", c.expected_b.value_or(unknown));
    json.number("measured_over_expected", c.measured_over_expected().value_or(unknown));
    std::vector<JsonObject> worst;
    for (const WorstPatch& patch : c.worst)
        worst.push_back(worst_json(c, patch));
    json.objects("worst", worst);
    return json;
}

} // namespace multipath
