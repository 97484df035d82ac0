#pragma once

#include "parallel/archive.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Water-filling (Cover and Thomas, Elements of Information Theory, section 9.4): divides rays among patches that have
/// had some already. Patch i, of importance w_i, gets max(0, level * w_i - lines_i), with one level for all.
class WaterFilling
{
public:
    WaterFilling();

    /// A patch of this importance (> 0) that is as well known as by so many lines.
    void add(double importance, double lines);
    void add(const WaterFilling& others);

    /// The level at which the patches get so many rays together, to a few per cent.
    double level(double rays) const;

private:
    struct Bin
    {
        double importance = 0.0; ///< sums over the patches of the bin
        double lines = 0.0;
    };

    std::vector<Bin> bins_; ///< by lines / importance, the level from which a patch gets rays
};

/// Whole numbers of rays for all patches of a scene. The rays are numbered patch by patch.
class Allotment
{
public:
    explicit Allotment(std::uint32_t patches = 0) : first_ray_(patches + std::size_t{1}, 0) {} ///< no rays

    /// `expected` rays per patch on the average, for `offset` uniform in [0, 1): see SystematicRounding.
    Allotment(const std::vector<double>& expected, double offset);

    std::uint64_t rays() const { return first_ray_.back(); }
    std::uint64_t first_ray(std::uint32_t patch) const { return first_ray_[patch]; } ///< patch <= number of patches
    std::uint64_t rays_of(std::uint32_t patch) const { return first_ray_[patch + 1] - first_ray_[patch]; }
    std::uint32_t patch_of(std::uint64_t ray) const; ///< ray < rays(); takes log n steps

    void visit(Archive& archive); ///< for a checkpoint, of as many patches

private:
    std::vector<std::uint64_t> first_ray_; ///< of each patch; one more than patches
};

} // namespace multipath
