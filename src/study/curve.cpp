#include "study/curve.h"

#include "base/elementary.h"
#include "radiosity/run/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

namespace multipath {

namespace {

double mean_of(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> logarithms(const std::vector<double>& values)
{
    std::vector<double> logs;
    for (const double value : values)
        logs.push_back(elementary::log(value));
    return logs;
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
    const std::vector<double> across = logarithms(xs);
    const std::vector<double> up = logarithms(ys);
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
    constexpr double tail = 0.05; // beyond either end of the interval
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

// With u = 1 + 1 / ratio and v = 1 + ratio in units of the measured error, the law is local u + global v = 1 at every
// point: two unknowns, by least squares.
std::optional<RatioLaw> fit_ratio(const std::vector<CurvePoint>& points)
{
    std::set<double> ratios;
    double uu = 0.0;
    double uv = 0.0;
    double vv = 0.0;
    double u1 = 0.0; // right-hand sides
    double v1 = 0.0;
    RatioLaw law;
    for (const CurvePoint& point : points) {
        if (!point.above_reference || !(point.setting > 0.0 && point.relative > 0.0) || !std::isfinite(point.setting))
            continue;
        const double u = (1.0 + 1.0 / point.setting) / point.relative;
        const double v = (1.0 + point.setting) / point.relative;
        uu += u * u;
        uv += u * v;
        vv += v * v;
        u1 += u;
        v1 += v;
        ++law.points;
        ratios.insert(point.setting);
    }
    const double determinant = uu * vv - uv * uv;
    if (ratios.size() < 3)
        return {};
    law.local = (vv * u1 - uv * v1) / determinant;
    law.global = (uu * v1 - uv * u1) / determinant;
    if (!(law.local > 0.0 && law.global > 0.0) || law.best() < *ratios.begin() || law.best() > *ratios.rbegin())
        return {};
    const double scatter = std::max(0.0, law.points - law.local * u1 - law.global * v1) / (law.points - 2);
    law.log_error = 0.5 * std::sqrt(scatter / determinant *
                                    (vv / (law.local * law.local) + uu / (law.global * law.global) +
                                     2.0 * uv / (law.local * law.global)));
    return law;
}

Estimate best_ratio(const RatioLaw& law)
{
    constexpr double tail = 0.05; // beyond either end of the interval
    const double factor = elementary::exp(student_quantile(tail, law.points - 2) * law.log_error);
    return {law.best(), law.best() / factor, law.best() * factor};
}

Estimate error_over_least(double ratio, const RatioLaw& law)
{
    const auto if_least_at = [&](double best) {
        return (best * best * (1.0 + 1.0 / ratio) + 1.0 + ratio) / ((1.0 + best) * (1.0 + best));
    };
    const Estimate best = best_ratio(law);
    const auto [least, largest] = std::minmax({if_least_at(best.low), if_least_at(best.high)});
    return {if_least_at(best.value), ratio > best.low && ratio < best.high ? 1.0 : least, largest};
}

} // namespace multipath
