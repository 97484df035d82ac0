#pragma once

#include "base/archive.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace multipath {

/// Systematic sampling (Madow and Madow 1944): items go to many recipients, and each recipient's expected number of
/// items is rounded at random to a whole number. The expected numbers are added up one after the other, starting from
/// an offset. A recipient's rounded number is how many integers the running sum reaches or passes when the recipient's
/// own term is added. If the offset is uniform in [0, 1), the mean of each rounded number is the expected number, and
/// the sums of all rounded and all expected numbers differ by less than 1.
class SystematicRounding
{
public:
    /// `begin`: the offset or, to continue at a later recipient, the running sum so far; at least 0.
    explicit SystematicRounding(double begin) : given_(whole(begin)) {}

    /// The rounded number of the next recipient. `sum`: the running sum including the recipient's own term; it must not
    /// be smaller than the sum before.
    std::uint64_t up_to(double sum)
    {
        const std::uint64_t before = given_;
        given_ = whole(sum);
        return given_ - before;
    }
    /// The whole part of the running sum: the sum of all rounded numbers, if `begin` was in [0, 1).
    std::uint64_t given() const { return given_; }

    /// The largest whole number not above `sum` >= 0.
    static std::uint64_t whole(double sum) { return static_cast<std::uint64_t>(std::floor(sum)); }

private:
    std::uint64_t given_;
};

/// Water-filling (Cover and Thomas, Elements of Information Theory, section 9.4): finds how to distribute rays among
/// receivers that already have lines_i lines. Receiver i of importance w_i gets max(0, level * w_i - lines_i) rays,
/// with one level for all. Only sums over bins of similar receivers are stored, so the level is right to a few per
/// cent.
class WaterFilling
{
public:
    WaterFilling();

    /// Adds a receiver of importance w > 0 that already has `lines` >= 0 lines, or an estimate as good as that many
    /// lines would give.
    void add(double importance, double lines);
    /// Adds all receivers of another object.
    void add(const WaterFilling& others);

    /// The level at which all receivers together get `rays` rays, to a few per cent. 0 without receivers.
    double level(double rays) const;

private:
    struct Bin
    {
        double importance = 0.0; ///< sum of w over the receivers of the bin
        double lines = 0.0;      ///< sum of their lines
    };

    /// 16 bins per octave of lines / importance, the level above which a receiver gets rays; in ascending order.
    std::vector<Bin> bins_;
};

/// The number of rays of every patch of a scene. The rays are numbered from 0, patch by patch.
class Allotment
{
public:
    explicit Allotment(std::uint32_t patches = 0) : first_ray_(patches + std::size_t{1}, 0) {} ///< no rays

    /// Rounds the `expected` number of rays of each patch to a whole number (SystematicRounding, which starts at
    /// `offset`). If `offset` is uniformly random in [0, 1), each patch gets its expected number on the average.
    Allotment(const std::vector<double>& expected, double offset);

    std::uint64_t rays() const { return first_ray_.back(); } ///< of all patches together
    /// Number of the first ray of the patch. For patch = number of patches, this is rays().
    std::uint64_t first_ray(std::uint32_t patch) const { return first_ray_[patch]; }
    std::uint64_t rays_of(std::uint32_t patch) const { return first_ray_[patch + 1] - first_ray_[patch]; }
    std::uint32_t patch_of(std::uint64_t ray) const; ///< needs ray < rays(); takes log n steps for n patches

    /// Saves the numbers to a checkpoint or restores them. Throws ArchiveError if those in the checkpoint are damaged,
    /// or belong to another number of patches.
    void visit(Archive& archive);

private:
    std::vector<std::uint64_t> first_ray_; ///< per patch; one more entry holds the number of all rays
};

} // namespace multipath
