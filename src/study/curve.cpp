#include "study/curve.h"

#include "base/elementary.h"
#include "base/lists.h"
#include "radiosity/run/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>

namespace multipath {

namespace {

constexpr double tail = 0.05; // of intervals and tests, both sides

double mean_of(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

double PowerLaw::at(double x) const
{
    return factor * elementary::pow(x, exponent);
}

std::optional<PowerLaw> fit_power_law(const std::vector<double>& xs, const std::vector<double>& ys)
{
    if (std::set<double>(xs.begin(), xs.end()).size() < 3)
        return {};
    const std::vector<double> across = mapped(xs, elementary::log);
    const std::vector<double> up = mapped(ys, elementary::log);
    const double centre = mean_of(across);
    const double level = mean_of(up);
    double spread = 0.0;
    double joint = 0.0;
    for (std::size_t k = 0; k < xs.size(); ++k) {
        spread += (across[k] - centre) * (across[k] - centre);
        joint += (across[k] - centre) * (up[k] - level);
    }
    PowerLaw law;
    law.exponent = joint / spread;
    law.factor = elementary::exp(level - law.exponent * centre);
    law.points = static_cast<int>(xs.size());
    double scatter = 0.0;
    for (std::size_t k = 0; k < xs.size(); ++k) {
        const double beside = up[k] - level - law.exponent * (across[k] - centre);
        scatter += beside * beside;
    }
    law.exponent_error = std::sqrt(scatter / static_cast<double>(law.points - 2) / spread);
    return law;
}

double exponent_interval(const PowerLaw& law)
{
    return student_quantile(tail, law.points - 2) * law.exponent_error;
}

double RatioLaw::best() const
{
    return std::sqrt(local / global);
}

bool operator==(const CurveKind& a, const CurveKind& b)
{
    const auto parts = [](const CurveKind& k) {
        return std::tie(k.method, k.sequence, k.pairing, k.chords, k.line_order);
    };
    return parts(a) == parts(b);
}

double abscissa(const CurvePoint& point, Abscissa against)
{
    switch (against) {
    case Abscissa::lines:
        return static_cast<double>(point.lines);
    case Abscissa::seconds:
        return point.seconds;
    default:
        return point.setting;
    }
}

std::optional<PowerLaw> fit(const std::vector<CurvePoint>& points, Abscissa against)
{
    std::vector<double> xs;
    std::vector<double> errors;
    for (const CurvePoint& point : points)
        if (const double x = abscissa(point, against); point.above_reference && x > 0.0 && point.relative > 0.0) {
            xs.push_back(x);
            errors.push_back(point.relative);
        }
    return fit_power_law(xs, errors);
}

// All fits are linear in the errors of an execution, since the weights are those of the mean errors. So the law of the
// mean error is the mean of the laws, and if the law holds the constant has the mean 0.

namespace {

/// The law of execution k, by least squares: local u + global v = error / mean at every point, with
/// u = (1 + 1 / ratio) / mean and v = (1 + ratio) / mean.
RatioLaw fit_law(const std::vector<CurvePoint>& points, std::size_t k)
{
    double uu = 0.0;
    double uv = 0.0;
    double vv = 0.0;
    double ue = 0.0; // right-hand sides
    double ve = 0.0;
    for (const CurvePoint& point : points) {
        const CurvePoint& execution = point.executions[k];
        const double u = (1.0 + 1.0 / execution.setting) / point.relative;
        const double v = (1.0 + execution.setting) / point.relative;
        uu += u * u;
        uv += u * v;
        vv += v * v;
        ue += u * execution.relative / point.relative;
        ve += v * execution.relative / point.relative;
    }
    const double determinant = uu * vv - uv * uv;
    return {(vv * ue - uv * ve) / determinant, (uu * ve - uv * ue) / determinant};
}

/// exp of the mean and the interval of the jackknife's pseudo-values. `logarithm` of k: from all executions but k; of
/// their number: from all.
template <class Logarithm>
Estimate jackknife(std::size_t executions, const Logarithm& logarithm)
{
    const double all = logarithm(executions);
    if (executions < 2)
        return {elementary::exp(all), 0.0, std::numeric_limits<double>::infinity()};
    RunningMean mean;
    for (std::size_t k = 0; k < executions; ++k)
        mean.add(all + static_cast<double>(executions - 1) * (all - logarithm(k)));
    const double half = student_quantile(tail, static_cast<int>(executions) - 1) * mean.standard_error();
    return {elementary::exp(mean.mean()), elementary::exp(mean.mean() - half), elementary::exp(mean.mean() + half)};
}

} // namespace

std::optional<RatioFindings> ratio_findings(const std::vector<CurvePoint>& points)
{
    std::vector<CurvePoint> used;
    std::set<double> ratios;
    for (const CurvePoint& point : points)
        if (point.above_reference && point.relative > 0.0 && point.setting > 0.0 && std::isfinite(point.setting)) {
            used.push_back(point);
            ratios.insert(point.setting);
        }
    if (used.size() < 4 || ratios.size() < 3)
        return {};
    const std::size_t count = used[0].executions.size();
    std::vector<RatioLaw> laws;
    RunningMean constant; // beside the two terms of the law, but for a positive factor
    for (std::size_t k = 0; k < count; ++k) {
        laws.push_back(fit_law(used, k));
        double sum = 0.0;
        for (const CurvePoint& p : used)
            sum += (p.executions[k].relative - laws[k].at(p.executions[k].setting)) / (p.relative * p.relative);
        constant.add(sum);
    }
    RatioFindings found;
    if (count > 1 && constant.standard_error() > 0.0)
        found.probability =
            student_tail(std::abs(constant.mean()) / constant.standard_error(), static_cast<int>(count) - 1);
    const bool holds =
        found.probability.value_or(1.0) >= tail && std::all_of(laws.begin(), laws.end(), [&](const RatioLaw& law) {
            return law.local > 0.0 && law.global > 0.0 && law.best() > *ratios.begin() && law.best() < *ratios.rbegin();
        });

    const auto mean_but = [&](std::size_t but, const auto& value) { // of all executions but one
        RunningMean mean;
        for (std::size_t k = 0; k < count; ++k)
            if (k != but)
                mean.add(value(k));
        return mean.mean();
    };
    const auto law_but = [&](std::size_t but) -> RatioLaw {
        return {mean_but(but, [&](std::size_t k) { return laws[k].local; }),
                mean_but(but, [&](std::size_t k) { return laws[k].global; })};
    };
    const auto error_at = [&](const CurvePoint& point, std::size_t but) {
        return mean_but(but, [&](std::size_t k) {
            const CurvePoint& execution = point.executions[k];
            return holds ? laws[k].at(execution.setting) : execution.relative;
        });
    };
    const CurvePoint& lowest = *std::min_element(
        used.begin(), used.end(), [](const CurvePoint& a, const CurvePoint& b) { return a.relative < b.relative; });
    const auto least = [&](std::size_t but) {
        return holds ? law_but(but).at(law_but(but).best()) : error_at(lowest, but);
    };
    found.least = least(count);
    found.best = {lowest.setting, 0.0, std::numeric_limits<double>::infinity()};
    if (holds) {
        found.law = law_but(count);
        found.best = jackknife(count, [&](std::size_t but) { return elementary::log(law_but(but).best()); });
    }
    const auto pilot =
        std::find_if(used.begin(), used.end(), [](const CurvePoint& point) { return point.rule == "measured"; });
    for (const CurvePoint& point : used)
        if (!point.rule.empty()) {
            found.loss[point.rule] =
                jackknife(count, [&](std::size_t but) { return elementary::log(error_at(point, but) / least(but)); });
            if (point.rule == "auto" && pilot != used.end())
                found.formula_over_pilot = jackknife(count, [&](std::size_t but) {
                    return elementary::log(error_at(point, but) / error_at(*pilot, but));
                });
        }
    return found;
}

} // namespace multipath
