#pragma once

#include "base/mix_bits.h"

#include <cstdint>
#include <cstring>

namespace multipath {

/// Counter-based random number generator: returns 64 random bits, a function of the stream's key and a counter, so that
/// any part of a stream can be generated without the rest. It is SplitMix64 (Steele, Lea and Flood 2014) with random
/// access.
inline std::uint64_t random_bits(std::uint64_t key, std::uint64_t counter)
{
    return mix_bits(key + 0x9e3779b97f4a7c15u * (counter + 1));
}

/// Independent streams of random numbers, one for each purpose. The values are arbitrary, but fixed.
enum class RandomStream : std::uint64_t {
    runs = 0, ///< seeds of the runs of a study and of the selftest
    random_sequence = 0x6a09e667f3bcc908u,
    sobol_shift = 0xbb67ae8584caa73bu,
    sobol_scrambling = 0x3c6ef372fe94f82bu,
    halton_permutations = 0xa54ff53a5f1d36f1u,
    halton_shift = 0x510e527fade682d1u,
    kronecker = 0x9b05688c2b3e6c1fu,
    shuffled_blocks = 0x13198a2e03707344u,
    rounded_shots = 0x5be0cd19137e2179u, ///< rounding of rays in the passes of the extended first shot
    particles = 0x1f83d9abfb41bd6bu,     ///< paths of particles after their first segments
    pair_rays = 0x243f6a8885a308d3u,     ///< rounding of rays between pairs of patches
    series_rays = 0x7137449123ef65cdu,   ///< rounding of rays in the passes of send_series (stochastic_jacobi.h)
    jacobi_rays = 0xe9b5dba58189dbbcu,   ///< rounding of rays in stochastic Jacobi iterations
    replicates = 0x452821e638d01377u,    ///< seeds of the replicates of a run
    stretches = 0xbe5466cf34e90c6cu,     ///< seeds of the parts of a run that is solved in several parts
    trapped_light = 0x3f84d5b5b5470917u,
    light_grid = 0x2e1b21385c26c926u, ///< rays from the points of a grid in space (light_grid.h)
    chosen_patches = 0x6c69676874,    ///< sample of patches that are examined for direct light
    first_estimate_of_truth =
        0xa4093822299f31d0u, ///< rays of the first of two independent estimates at a point (shown_error.h)
    second_estimate_of_truth = 0x082efa98ec4e6c89u, ///< rays of the second estimate
    patch_error = 0xc0ac29b7c97c50ddu,              ///< seeds of the two solutions in patch_error() (shown_error.h)
};

/// Key of a stream that does not depend on a seed.
constexpr std::uint64_t random_key(RandomStream stream)
{
    return static_cast<std::uint64_t>(stream);
}

/// Key of a stream that depends on the seed.
inline std::uint64_t random_key(RandomStream stream, std::uint64_t seed)
{
    return mix_bits(seed ^ random_key(stream));
}

/// Maps uniform bits to a uniform number in [0, 1): the upper 52 bits become the fraction of a number in [1, 2), and 1
/// is subtracted from this number. The map is exact and, unlike a conversion from integers, available in the vector
/// units of every processor.
inline double bits_to_unit(std::uint64_t bits)
{
    const std::uint64_t one_to_two = 0x3ff0000000000000u | bits >> 12;
    double value = 0.0;
    std::memcpy(&value, &one_to_two, sizeof value);
    return value - 1.0;
}

} // namespace multipath
