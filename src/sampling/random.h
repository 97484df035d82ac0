#pragma once

#include "parallel/mix_bits.h"

#include <cstdint>
#include <cstring>

namespace multipath {

/// Counter-based generator: number `counter` of the stream `key` is a function of the two, so that any part of a
/// stream can be had without the rest. The counter walks by the golden ratio as in SplitMix64.
inline std::uint64_t random_bits(std::uint64_t key, std::uint64_t counter)
{
    return mix_bits(key + 0x9e3779b97f4a7c15u * (counter + 1));
}

/// Independent streams of random numbers, one for each purpose. The values are arbitrary.
enum class RandomStream : std::uint64_t {
    runs = 0, ///< seeds of the runs of a study and of the self test
    random_sequence = 0x6a09e667f3bcc908u,
    sobol_shift = 0xbb67ae8584caa73bu,
    sobol_scrambling = 0x3c6ef372fe94f82bu,
    halton_permutations = 0xa54ff53a5f1d36f1u,
    halton_shift = 0x510e527fade682d1u,
    kronecker = 0x9b05688c2b3e6c1fu,
    shuffled_blocks = 0x13198a2e03707344u,
    rounded_shots = 0x5be0cd19137e2179u, ///< of the passes of the extended first shot
    particles = 0x1f83d9abfb41bd6bu,
    pair_rays = 0x243f6a8885a308d3u,
    series_rays = 0x7137449123ef65cdu, ///< of the passes of the stochastic Jacobi method
    jacobi_rays = 0xe9b5dba58189dbbcu, ///< and of its iterations
    replicates = 0x452821e638d01377u,
    stretches = 0xbe5466cf34e90c6cu,
    trapped_light = 0x3f84d5b5b5470917u,
    light_grid = 0x2e1b21385c26c926u,  ///< rays of the points of a grid
    chosen_patches = 0x6c69676874,     ///< of the search for direct light
    first_truth = 0xa4093822299f31d0u, ///< rays of the two estimates at a point (shown_error.h)
    second_truth = 0x082efa98ec4e6c89u,
    patch_error = 0xc0ac29b7c97c50ddu, ///< of the two solutions that tell it
};

/// Key of a stream that no seed changes.
constexpr std::uint64_t random_key(RandomStream stream)
{
    return static_cast<std::uint64_t>(stream);
}

/// Key of a stream that each seed has of its own.
inline std::uint64_t random_key(RandomStream stream, std::uint64_t seed)
{
    return mix_bits(seed ^ random_key(stream));
}

/// Uniform in [0, 1): the upper 52 bits become the fraction of a number in [1, 2), which is then shifted down. Exact,
/// and unlike a conversion from integer available in the vector units of every processor.
inline double bits_to_unit(std::uint64_t bits)
{
    const std::uint64_t one_to_two = 0x3ff0000000000000u | bits >> 12;
    double value = 0.0;
    std::memcpy(&value, &one_to_two, sizeof value);
    return value - 1.0;
}

} // namespace multipath
