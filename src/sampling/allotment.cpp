#include "sampling/allotment.h"

#include "base/errors.h"
#include "base/memory.h"

#include <cstring>

namespace multipath {

namespace {

constexpr int bins_per_octave_bits = 4;

/// The bin of a level: the exponent and the leading bits of the fraction of a float, 16 bins per octave.
std::size_t bin_of(double level)
{
    const auto single = static_cast<float>(level);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &single, sizeof bits);
    return bits >> (23 - bins_per_octave_bits);
}

/// The lowest level of a bin.
double lowest_level(std::size_t bin)
{
    const auto bits = static_cast<std::uint32_t>(bin << (23 - bins_per_octave_bits));
    float level = 0.0f;
    std::memcpy(&level, &bits, sizeof level);
    return static_cast<double>(level);
}

} // namespace

WaterFilling::WaterFilling() : bins_(std::size_t{1} << (8 + bins_per_octave_bits)) {}

void WaterFilling::add(double importance, double lines)
{
    Bin& bin = bins_[bin_of(lines / importance)];
    bin.importance += importance;
    bin.lines += lines;
}

void WaterFilling::add(const WaterFilling& others)
{
    for (std::size_t k = 0; k < bins_.size(); ++k) {
        bins_[k].importance += others.bins_[k].importance;
        bins_[k].lines += others.bins_[k].lines;
    }
}

double WaterFilling::level(double rays) const
{
    double importance = 0.0; // sums over the receivers that get rays
    double lines = 0.0;
    double level = 0.0;
    for (std::size_t k = 0; k < bins_.size(); ++k) {
        if (importance > 0.0 && level <= lowest_level(k))
            break;
        importance += bins_[k].importance;
        lines += bins_[k].lines;
        if (importance > 0.0)
            level = (rays + lines) / importance;
    }
    return level;
}

Allotment::Allotment(const std::vector<double>& expected, double offset)
    : first_ray_(vector_with_capacity<std::uint64_t>(expected.size() + 1))
{
    first_ray_.push_back(0);
    double sum = offset;
    for (const double rays : expected)
        first_ray_.push_back(whole_part(sum += rays));
}

std::uint32_t Allotment::recipient_of(std::uint64_t ray) const
{
    const auto after = std::upper_bound(first_ray_.begin(), first_ray_.end(), ray);
    return static_cast<std::uint32_t>(after - first_ray_.begin() - 1);
}

void Allotment::visit(Archive& archive)
{
    archive.list<std::uint64_t>("first rays", first_ray_);
    if (first_ray_.front() != 0 || !std::is_sorted(first_ray_.begin(), first_ray_.end()))
        throw ArchiveError("the state is damaged: no such rays");
}

} // namespace multipath
