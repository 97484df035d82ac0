// Each statement of the paper becomes a measured number with a 95 % interval and a range in which the number must lie.
// The statement holds if the interval lies inside the range, differs if it lies outside, and is undecided otherwise.
// The result of formula (3), which has no interval, must agree with the printed one to 0.015.

#include "base/elementary.h"
#include "study/paper_report.h"

#include "radiosity/run/statistics.h"
#include "study/study_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace multipath {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// `half`: half the width of the interval.
Estimate estimate(double value, double half)
{
    return {value, value - half, value + half};
}

/// Relative MSE of one point over that of another, each the mean of so many executions. The interval is by Student's t,
/// since the scatter is estimated from the executions.
Estimate ratio_of(const CurvePoint& above, const CurvePoint& below, int executions)
{
    const double value = above.relative / below.relative;
    const double error =
        value * elementary::hypot(above.relative_error / above.relative, below.relative_error / below.relative);
    return estimate(value, executions < 2 ? infinity : student_quantile(0.05, 2 * (executions - 1)) * error);
}

/// Relative MSE of a method over that of another one, at the largest number of lines, with random lines.
Estimate error_ratio(const Study& study, const char* method, const char* other)
{
    return ratio_of(curve_of(study, method, "random").points.back(), curve_of(study, other, "random").points.back(),
                    study.executions);
}

Estimate slope_of(const Curve& curve)
{
    return curve.law ? estimate(curve.law->exponent, exponent_interval(*curve.law)) : estimate(0.0, infinity);
}

Estimate difference(const Estimate& a, const Estimate& b)
{
    return estimate(a.value - b.value, elementary::hypot(a.high - a.value, b.high - b.value));
}

std::string words(const Estimate& measured, int decimals)
{
    if (std::isinf(measured.high))
        return "none";
    return fixed(measured.value, decimals) + " ± " + fixed(measured.high - measured.value, decimals);
}

/// Verdict on whether a number is between two limits: undecided if its interval contains one of them.
Verdict between(const Estimate& measured, double low, double high)
{
    if (measured.low > low && measured.high < high)
        return Verdict::holds;
    return measured.high < low || measured.low > high ? Verdict::differs : Verdict::undecided;
}

using MeasuredSlopes = std::array<Estimate, 2>; ///< on 5CUBES and on 4CHAIRS

MeasuredSlopes slopes(const PaperFindings& f, const char* sequence)
{
    return {slope_of(curve_of(f.study("figure3"), "first-shot", sequence)),
            slope_of(curve_of(f.study("figure4"), "first-shot", sequence))};
}

/// The claim that both numbers are between two limits.
Claim both_between(const char* statement, const char* expected, const MeasuredSlopes& slopes, double low, double high)
{
    return {statement, expected, words(slopes[0], 3) + " and " + words(slopes[1], 3),
            std::max(between(slopes[0], low, high), between(slopes[1], low, high))};
}

Claim sobol_as_printed(const PaperFindings& f)
{
    const MeasuredSlopes found = slopes(f, "sobol");
    const MeasuredSlopes off = {difference(found[0], estimate(published_slopes.back().five_cubes, 0.0)),
                                difference(found[1], estimate(published_slopes.back().four_chairs, 0.0))};
    Claim claim = both_between("Sobol's slopes are those of Table 1", "−1.102 and −1.122, within 0.1", off, -0.1, 0.1);
    claim.found += " off";
    return claim;
}

/// Compares the slopes for the larger bases on the same scene with coarse and fine patches.
Claim halton_varies(const PaperFindings& f)
{
    const char* const large_bases = "halton:11,13,17,19";
    const auto coarse = [&](const char* sequence) {
        return slope_of(curve_of(f.study("order"), "first-shot", sequence, "sequence"));
    };
    const Estimate large = coarse(large_bases);
    const Estimate fine = slope_of(curve_of(f.study("figure3"), "first-shot", large_bases));
    return {"Halton's slope depends on bases and scene", "−0.844 to −1.113",
            words(coarse("halton:2,7,3,5"), 3) + " and " + words(large, 3) + " with patches of 0.5, the latter " +
                words(fine, 3) + " with smaller ones",
            between(difference(large, fine), 0.0, infinity)};
}

Claim pairs_fail(const PaperFindings& f)
{
    const Study& study = f.study("pairs");
    const auto fall = [&](const char* pairing) {
        const std::vector<CurvePoint>& points = curve_of(study, "first-shot", "sobol", "", pairing).points;
        return ratio_of(points.front(), points.back(), study.executions);
    };
    const std::vector<CurvePoint>& points = study.curves.at(0).points;
    const double lines = static_cast<double>(points.back().lines) / static_cast<double>(points.front().lines);
    return {"With two 2-D items for a line the error does not converge, with one 4-D item it does", "error “enormous”",
            "with " + fixed(lines, 0) + " times the lines the error falls by " + fixed(fall("2d").value, 1) +
                " with pairs, by " + fixed(fall("4d").value, 0) + " without",
            std::max(between(fall("2d"), 0.0, 4.0), between(fall("4d"), 0.7 * lines, infinity))};
}

Claim budget(const std::string& what, const PublishedBudget& printed, double ratio)
{
    const bool near = std::abs(ratio - printed.ratio) <= 0.015;
    return {"(3) for " + what, fixed(printed.ratio, 2), fixed(ratio, 3), near ? Verdict::holds : Verdict::differs};
}

/// The claim that the error of a method over that of another one is between two limits. `times`: what the ratio
/// multiplies.
Claim ratio_between(const std::string& statement, const std::string& expected, const Estimate& ratio, int decimals,
                    const std::string& times, double low, double high)
{
    return {statement, expected, words(ratio, decimals) + " times " + times, between(ratio, low, high)};
}

Claim floor_lit(const PaperFindings& f)
{
    const Estimate first = error_ratio(f.study("figure9"), "first-shot", "local");
    const Estimate extended = error_ratio(f.study("figure9"), "extended", "local");
    return {"Figure 9: lit downwards, the multi-path methods beat local Monte Carlo", "both better",
            "first shot " + words(first, 2) + ", extended " + words(extended, 2) + " times its error",
            std::max(between(first, 0.0, 1.0), between(extended, 0.0, 1.0))};
}

} // namespace

const Curve& curve_of(const Study& study, const std::string& method, const std::string& sequence,
                      const std::string& line_order, const std::string& pairing)
{
    for (const Curve& curve : study.curves)
        if (curve.kind.method == method && curve.kind.sequence == sequence &&
            (line_order.empty() || curve.kind.line_order == line_order) &&
            (pairing.empty() || curve.kind.pairing == pairing))
            return curve;
    throw std::out_of_range("the study has no curve " + method + ", " + sequence);
}

std::vector<Claim> paper_claims(const PaperFindings& f)
{
    const SceneReport& up = f.four_chairs_up.report;
    const SceneReport& down = f.four_chairs.report;
    return {
        both_between("With random lines the error falls as 1/N, formula (2)", "slope −1 ± 0.05 on both scenes",
                     slopes(f, "random"), -1.05, -0.95),
        both_between("Sobol's lines do better on both scenes", "slope below −1", slopes(f, "sobol"), -infinity, -1.0),
        sobol_as_printed(f),
        halton_varies(f),
        pairs_fail(f),
        budget("4CHAIRS lit upwards, first shot", published_up, up.ratio_first_shot.value()),
        budget("4CHAIRS lit downwards, first shot", published_down, down.ratio_first_shot.value()),
        budget("4CHAIRS, extended first shot", published_extended, down.ratio_extended.value()),
        ratio_between("Figure 7: lit upwards, the extended first shot is better than the first shot", "far better",
                      error_ratio(f.study("figure7"), "first-shot", "extended"), 1, "less error", 2.0, infinity),
        ratio_between("Figure 8: lit upwards, the extended first shot is like local Monte Carlo",
                      "“of similar quality”", error_ratio(f.study("figure8"), "extended", "local"), 2, "its error", 0.5,
                      2.0),
        floor_lit(f),
        ratio_between("Figure 9: extending the first shot does not pay there", "no noticeable improvement",
                      error_ratio(f.study("figure9"), "extended", "first-shot"), 2, "the error of the first shot", 0.7,
                      1.3)};
}

std::vector<Claim> ratio_claims(const PaperFindings& f, const std::string& rule)
{
    std::vector<Claim> claims;
    for (const auto& [name, title] : report_scenes)
        for (const Curve& curve : f.study("ratio-" + std::string(name)).curves) {
            Claim claim = {std::string(title) + ", " + curve.kind.method + ", " + curve.kind.sequence, "–", "–",
                           Verdict::undecided};
            const auto chosen = std::find_if(curve.points.begin(), curve.points.end(), [&](const CurvePoint& point) {
                return point.rule == rule && std::isfinite(point.setting);
            });
            if (const std::optional<RatioFindings>& ratios = curve.ratios;
                ratios && chosen != curve.points.end() && ratios->loss.count(rule) > 0) {
                const Estimate& error = ratios->loss.at(rule);
                const bool compares = rule == "measured" && ratios->formula_over_pilot;
                claim.expected =
                    compares ? interval_words(*ratios->formula_over_pilot)
                             : interval_words(ratios->best) + (ratios->law ? "" : ", measured") + fit_words(*ratios);
                claim.found = fixed(chosen->setting, 2) + ": " + interval_words(error);
                claim.verdict = between(error, 0.0, 1.03);
            }
            claims.push_back(claim);
        }
    return claims;
}

std::vector<Claim> threshold_claims(const PaperFindings& f)
{
    std::vector<Claim> claims;
    for (std::size_t k = 0; k < 3; ++k) {
        const Study& study = f.study("threshold-" + std::string(report_scenes[k][0]));
        for (const Curve& curve : study.curves) {
            const auto at = [&](double threshold) {
                const auto found = std::find_if(curve.points.begin(), curve.points.end(),
                                                [&](const CurvePoint& point) { return point.setting == threshold; });
                return found != curve.points.end() ? *found : throw std::out_of_range("no such threshold");
            };
            const auto times = [&](double threshold) { return ratio_of(at(threshold), at(1.0), study.executions); };
            claims.push_back({std::string(report_scenes[k][1]) + ", " + curve.kind.sequence,
                              words(times(0.25), 2) + "; " + words(times(4.0), 2),
                              words(times(0.0), 2) + "; " + words(times(16.0), 2),
                              std::max(between(times(0.0), 1.0, infinity), between(times(16.0), 1.0, infinity))});
        }
    }
    return claims;
}

} // namespace multipath
