#include "contest.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace multipath {

namespace {

constexpr int rounds = 7;

volatile double used = 0.0;

double processor_seconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Median, least and largest.
struct Spread
{
    double median;
    double low;
    double high;
};

Spread spread_of(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return {values[values.size() / 2], values.front(), values.back()};
}

std::string ratio_text(const Contestant& contestant, const std::vector<Contestant>& all)
{
    const auto rival =
        std::find_if(all.begin(), all.end(), [&](const Contestant& c) { return c.name == contestant.rival; });
    if (rival == all.end())
        return "";
    std::vector<double> ratios;
    for (std::size_t round = 0; round < contestant.rates.size(); ++round)
        ratios.push_back(contestant.rates[round] / rival->rates[round]);
    const Spread ratio = spread_of(ratios);
    char text[128];
    std::snprintf(text, sizeof text, "   %5.2f x %s (%.2f ... %.2f)", ratio.median, rival->name.c_str(), ratio.low,
                  ratio.high);
    return text;
}

} // namespace

void compete(const std::string& title, std::vector<Contestant> contestants)
{
    std::printf("\n%s\n", title.c_str());
    for (int round = 0; round < rounds; ++round)
        for (Contestant& contestant : contestants) {
            double pieces = 0.0;
            double seconds = 0.0;
            for (std::size_t part = 0; part < contestant.parts; ++part) {
                if (contestant.prepare)
                    contestant.prepare(part);
                const double start = processor_seconds();
                pieces += contestant.run();
                seconds += processor_seconds() - start;
            }
            contestant.rates.push_back(pieces / seconds);
        }
    for (const Contestant& contestant : contestants) {
        const Spread rate = spread_of(contestant.rates);
        std::printf("  %-44s %8.2f  (%.2f ... %.2f) million %s/s%s\n", contestant.name.c_str(), 1e-6 * rate.median,
                    1e-6 * rate.low, 1e-6 * rate.high, contestant.unit.c_str(),
                    ratio_text(contestant, contestants).c_str());
    }
    std::fflush(stdout);
}

void use(double value)
{
    used = used + value;
}

} // namespace multipath
