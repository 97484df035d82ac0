#include "study/curve.h"

#include <tuple>

namespace multipath {

bool operator==(const CurveKind& a, const CurveKind& b)
{
    const auto parts = [](const CurveKind& k) {
        return std::tie(k.method, k.sequence, k.pairing, k.chords, k.line_order);
    };
    return parts(a) == parts(b);
}

std::optional<PowerLaw> fit(const std::vector<CurvePoint>& points)
{
    std::vector<double> lines;
    std::vector<double> errors;
    for (const CurvePoint& point : points)
        if (point.above_reference) {
            lines.push_back(static_cast<double>(point.lines));
            errors.push_back(point.relative);
        }
    return fit_power_law(lines, errors);
}

} // namespace multipath
