#pragma once

#include "parallel/archive.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Water-filling (Cover and Thomas, Elements of Information Theory, section 9.4): distributes rays among receivers that
/// already have lines_i lines. Receiver i of importance w_i gets max(0, level * w_i - lines_i) rays, with one level for
/// all. Receivers are sorted into bins, which makes the level right to a few per cent.
class WaterFilling
{
public:
    WaterFilling();

    /// Adds a receiver of this importance (> 0) whose estimate is as good as one from `lines` lines (>= 0).
    void add(double importance, double lines);
    /// Adds the receivers of another object.
    void add(const WaterFilling& others);

    /// The level at which all receivers together get `rays` rays, to a few per cent. 0 without receivers.
    double level(double rays) const;

private:
    struct Bin
    {
        double importance = 0.0; ///< sum over the receivers of the bin
        double lines = 0.0;      ///< likewise
    };

    std::vector<Bin> bins_; ///< in order of lines / importance, the level above which a receiver gets rays
};

/// The number of rays of every patch of a scene. The rays are numbered patch by patch.
class Allotment
{
public:
    explicit Allotment(std::uint32_t patches = 0) : first_ray_(patches + std::size_t{1}, 0) {} ///< no rays

    /// Rounds the `expected` rays of each patch to whole numbers that keep their expectations if `offset` is uniform in
    /// [0, 1) (SystematicRounding).
    Allotment(const std::vector<double>& expected, double offset);

    std::uint64_t rays() const { return first_ray_.back(); }
    std::uint64_t first_ray(std::uint32_t patch) const
    {
        return first_ray_[patch];
    } ///< patch <= number of patches; at it, rays()
    std::uint64_t rays_of(std::uint32_t patch) const { return first_ray_[patch + 1] - first_ray_[patch]; }
    std::uint32_t patch_of(std::uint64_t ray) const; ///< ray < rays(); takes log n steps

    /// Saves to or restores from a checkpoint of a scene with as many patches. Throws ArchiveError for damaged numbers.
    void visit(Archive& archive);

private:
    std::vector<std::uint64_t> first_ray_; ///< per patch; then the number of all rays
};

} // namespace multipath
