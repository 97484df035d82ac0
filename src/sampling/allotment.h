#pragma once

#include "base/archive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Systematic sampling (Madow and Madow 1944): items go to many recipients, and each recipient's expected number of
/// items is rounded at random to a whole number. The expected numbers are added up one after the other, starting from
/// an offset. A recipient's rounded number is how many integers the running sum reaches or passes when the recipient's
/// own term is added: the difference of the whole parts of the sums after it and before it. If the offset is uniform in
/// [0, 1), the mean of each rounded number is the expected number, and the sums of all rounded and all expected numbers
/// differ by less than 1.
///
/// Whole part of a running sum >= 0: with an offset in [0, 1), the sum of all rounded numbers so far.
inline std::uint64_t whole_part(double running_sum)
{
    return static_cast<std::uint64_t>(std::floor(running_sum));
}

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

/// The numbers of rays of some recipients, such as the patches of a scene. The rays are numbered from 0, recipient by
/// recipient.
class Allotment
{
public:
    explicit Allotment(std::uint32_t recipients = 0) : first_ray_(recipients + std::size_t{1}, 0) {} ///< no rays

    /// Rounds the `expected` number of rays of each recipient to a whole number by systematic sampling that starts
    /// at `offset`. If `offset` is uniformly random in [0, 1), each gets its expected number on the average.
    Allotment(const std::vector<double>& expected, double offset);

    /// Adds a recipient after all others.
    void append(std::uint64_t rays) { first_ray_.push_back(first_ray_.back() + rays); }

    std::uint64_t rays() const { return first_ray_.back(); } ///< of all recipients together
    /// Number of the first ray of a recipient. For the number of recipients, this is rays().
    std::uint64_t first_ray(std::uint32_t recipient) const { return first_ray_[recipient]; }
    std::uint64_t rays_of(std::uint32_t recipient) const { return first_ray_[recipient + 1] - first_ray_[recipient]; }
    std::uint32_t recipient_of(std::uint64_t ray) const; ///< needs ray < rays(); takes log n steps for n recipients

    /// Calls take(recipient, first, count) for the recipients of the rays first_ray ... first_ray + count - 1, each
    /// with its part of these rays, in order.
    template <class Take>
    void for_range(std::uint64_t first_ray, std::uint64_t count, const Take& take) const;

    /// Saves the numbers to a checkpoint or restores them. Throws ArchiveError if those in the checkpoint are damaged,
    /// or belong to another number of recipients.
    void visit(Archive& archive);

private:
    std::vector<std::uint64_t> first_ray_; ///< per recipient; one more entry holds the number of all rays
};

template <class Take>
void Allotment::for_range(std::uint64_t first_ray, std::uint64_t count, const Take& take) const
{
    const std::uint64_t end = first_ray + count;
    std::uint32_t recipient = count > 0 ? recipient_of(first_ray) : 0;
    for (std::uint64_t ray = first_ray; ray < end; ++recipient) {
        const std::uint64_t next = std::min(end, first_ray_[recipient + 1]);
        if (ray < next)
            take(recipient, ray, static_cast<std::size_t>(next - ray));
        ray = next;
    }
}

} // namespace multipath
