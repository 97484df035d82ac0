#include "study/number_words.h"
#include "study/paper_findings.h"
#include "study/published.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace multipath {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const CurvePoint& last_point(const Curve& curve)
{
    return curve.points.back();
}

/// A ratio of two means [1] and its standard error.
struct Ratio
{
    double value;
    double error;
};

/// Relative MSE with random lines at the most lines over that of another method.
Ratio error_ratio(const Study& study, const char* method, const char* other)
{
    const CurvePoint& above = last_point(curve_of(study, method, "random"));
    const CurvePoint& below = last_point(curve_of(study, other, "random"));
    const double value = above.relative / below.relative;
    return {value, value * std::hypot(above.relative_error / above.relative, below.relative_error / below.relative)};
}

std::string words(const Ratio& ratio, int decimals)
{
    return fixed(ratio.value, decimals) + " ± " + fixed(ratio.error, decimals);
}

Verdict verdict_of(bool holds)
{
    return holds ? Verdict::holds : Verdict::differs;
}

/// Within two standard errors of a limit nothing is decided.
Verdict between(const Ratio& ratio, double low, double high)
{
    if (ratio.value - 2.0 * ratio.error > low && ratio.value + 2.0 * ratio.error < high)
        return Verdict::holds;
    const bool outside = ratio.value + 2.0 * ratio.error < low || ratio.value - 2.0 * ratio.error > high;
    return outside ? Verdict::differs : Verdict::undecided;
}

/// Of both together.
Verdict worse(Verdict a, Verdict b)
{
    return std::max(a, b);
}

double exponent(const Curve& curve)
{
    return curve.law ? curve.law->exponent : std::nan("");
}

Claim random_slope(const PaperFindings& f)
{
    Claim claim{"With random lines the error falls as 1/N, formula (2)", "slope −1 ± 0.05 on both scenes", "",
                Verdict::holds, ""};
    for (const char* name : {"figure3", "figure4"}) {
        const Curve& curve = curve_of(f.study(name), "first-shot", "random");
        claim.found += (claim.found.empty() ? "" : " and ") + slope_words(curve.law);
        claim.verdict = worse(claim.verdict, verdict_of(std::abs(exponent(curve) + 1.0) <= 0.05));
    }
    return claim;
}

Claim sobol_below(const PaperFindings& f)
{
    Claim claim{"Sobol's lines do better on both scenes", "slope below −1", "", Verdict::holds, ""};
    for (const char* name : {"figure3", "figure4"}) {
        const Curve& curve = curve_of(f.study(name), "first-shot", "sobol");
        claim.found += (claim.found.empty() ? "" : " and ") + slope_words(curve.law);
        claim.verdict =
            worse(claim.verdict, verdict_of(curve.law && exponent(curve) + exponent_interval(*curve.law) < -1.0));
    }
    return claim;
}

Claim sobol_as_printed(const PaperFindings& f)
{
    const PublishedSlope& printed = published_slopes.back();
    const double cubes = exponent(curve_of(f.study("figure3"), "first-shot", "sobol"));
    const double chairs = exponent(curve_of(f.study("figure4"), "first-shot", "sobol"));
    const double off = std::max(std::abs(cubes - printed.five_cubes), std::abs(chairs - printed.four_chairs));
    return {"Sobol's slopes are those of Table 1", "−1.102 and −1.122, within 0.1", "at most " + fixed(off, 3) + " off",
            verdict_of(off <= 0.1), ""};
}

Claim halton_varies(const PaperFindings& f)
{
    const auto slope = [&](const char* sequence, const char* order) {
        return curve_of(f.study("order"), "first-shot", sequence, order).law;
    };
    const auto small = slope("halton:2,7,3,5", "sequence");
    const auto large = slope("halton:11,13,17,19", "sequence");
    const auto shuffled = slope("halton:11,13,17,19", "shuffled");
    Claim claim{"Halton's slope depends on bases and scene", "−0.844 to −1.113",
                slope_words(small) + " and " + slope_words(large) + " with patches of 0.5",
                verdict_of(small && large && large->exponent - small->exponent > exponent_interval(*large)), ""};
    claim.remark = "It is the order of the lines, not how evenly they fill space: shuffled, the same lines give " +
                   slope_words(shuffled) + " for the larger bases.";
    return claim;
}

Claim pairs_fail(const PaperFindings& f)
{
    const auto fall = [&](const char* pairing) {
        const Curve& curve = curve_of(f.study("pairs"), "first-shot", "sobol", "", pairing);
        return curve.points.front().relative / curve.points.back().relative;
    };
    const double lines = static_cast<double>(curve_of(f.study("pairs"), "first-shot", "sobol").points.back().lines) /
                         static_cast<double>(curve_of(f.study("pairs"), "first-shot", "sobol").points.front().lines);
    return {"Two 2-D items a line do not converge, one 4-D item does", "error “enormous”",
            "with " + fixed(lines, 0) + " times the lines the error falls by " + fixed(fall("2d"), 1) +
                " with pairs, by " + fixed(fall("4d"), 0) + " without",
            verdict_of(fall("2d") < 4.0 && fall("4d") > 0.7 * lines), ""};
}

Claim budget(const std::string& what, const PublishedBudget& printed, const BudgetFigures& figures, double ratio)
{
    const bool near = std::abs(ratio - printed.ratio) <= 0.015;
    return {"(3) for " + what, fixed(printed.ratio, 2), fixed(ratio, 3), verdict_of(near),
            "R_ave " + fixed(figures.average_reflectance, 3) + ", R_s' " + fixed(figures.secondary_reflectance, 3) +
                ", f " + fixed(figures.lit_fraction, 3) + ", n_int " + fixed(figures.intersections, 2)};
}

Claim ceiling_lit(const PaperFindings& f)
{
    const Ratio ratio = error_ratio(f.study("figure7"), "first-shot", "extended");
    return {"Figure 7: lit upwards, the extended first shot is better than the first shot", "far better",
            words(ratio, 1) + " times less error", between(ratio, 2.0, infinity), ""};
}

Claim ceiling_lit_local(const PaperFindings& f)
{
    const Ratio ratio = error_ratio(f.study("figure8"), "extended", "local");
    return {"Figure 8: lit upwards, the extended first shot is like local Monte Carlo", "“of similar quality”",
            words(ratio, 2) + " times its error", between(ratio, 0.5, 2.0), ""};
}

Claim floor_lit(const PaperFindings& f)
{
    const Ratio first = error_ratio(f.study("figure9"), "first-shot", "local");
    const Ratio extended = error_ratio(f.study("figure9"), "extended", "local");
    return {"Figure 9: lit downwards, the multi-path methods beat local Monte Carlo", "both better",
            "first shot " + words(first, 2) + ", extended " + words(extended, 2) + " times its error",
            worse(between(first, 0.0, 1.0), between(extended, 0.0, 1.0)),
            "First shot over local is " + words(error_ratio(f.study("figure9-coarse"), "first-shot", "local"), 2) +
                " with patches of 0.5 and " + words(error_ratio(f.study("figure9-fine"), "first-shot", "local"), 2) +
                " with patches of 0.15. How far they are apart depends on what the paper does not tell of its scene"};
}

Claim floor_lit_extended(const PaperFindings& f)
{
    const Ratio ratio = error_ratio(f.study("figure9"), "extended", "first-shot");
    return {"Figure 9: extending the first shot does not pay there", "no noticeable improvement",
            words(ratio, 2) + " times the error of the first shot", between(ratio, 0.7, 1.3), ""};
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
    return {random_slope(f),
            sobol_below(f),
            sobol_as_printed(f),
            halton_varies(f),
            pairs_fail(f),
            budget("4CHAIRS lit upwards, first shot", published_up, up.figures, up.ratio_first_shot.value()),
            budget("4CHAIRS lit downwards, first shot", published_down, down.figures, down.ratio_first_shot.value()),
            budget("4CHAIRS, extended first shot", published_extended, extended_figures(down.figures),
                   down.ratio_extended.value()),
            ceiling_lit(f),
            ceiling_lit_local(f),
            floor_lit(f),
            floor_lit_extended(f)};
}

} // namespace multipath
