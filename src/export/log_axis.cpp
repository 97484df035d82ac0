#include "export/log_axis.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr int most_powers = 14;
constexpr double least_width = 0.7; // [decades] holds two of 1, 2, 5, 10, 20 ... wherever it begins

/// "10^−4", "2·10^6"
std::string label_of(int times, int exponent)
{
    return (times == 1 ? "" : std::to_string(times) + "\u00b7") + (exponent < 0 ? "10^\u2212" : "10^") +
           std::to_string(std::abs(exponent));
}

} // namespace

PlotAxis log_axis(const std::string& title, double low, double high)
{
    if (low > high)
        return log_axis(title, 0.0, 1.0);
    const double room = std::max({0.13, 0.03 * (high - low), 0.5 * (least_width - (high - low))});
    PlotAxis axis{title, low - room, high + room, {}};
    const int first = static_cast<int>(std::floor(axis.low));
    const int last = static_cast<int>(std::floor(axis.high));
    const int step = 1 + (last - first) / most_powers;
    const bool few_powers = std::floor(axis.high) - std::ceil(axis.low) < 1.0;
    for (int exponent = first; exponent <= last; ++exponent)
        for (int times = 1; times <= (step == 1 ? 9 : 1); ++times) {
            const double value = exponent + std::log10(times);
            const bool labelled = times == 1 ? exponent % step == 0 : few_powers && (times == 2 || times == 5);
            if (value < axis.low || value > axis.high)
                continue;
            if (labelled)
                axis.ticks.push_back({value, label_of(times, exponent)});
            else
                axis.minor_ticks.push_back(value);
        }
    return axis;
}

} // namespace multipath
