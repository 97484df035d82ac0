// A hash table with open addressing and linear probing, keyed by the bits of the coordinates. For a large mesh the
// table is larger than the caches, so slots are prefetched, and an entry holds some bits of the hash, so that the
// coordinates of other vertices are rarely read.

#include "scene/vertex_weld.h"

#include "base/mix_bits.h"

#include <cmath>

namespace multipath {

namespace {

/// Limit of probing, so that a file made to cause collisions cannot slow the program down: after this many steps a
/// vertex becomes its own representative.
constexpr int most_steps = 64;

std::uint64_t hash_of(Vec3 p)
{
    return mix_bits(mix_bits(mix_bits(bits_of(p.x)) ^ bits_of(p.y)) ^ bits_of(p.z));
}

} // namespace

Vec3 snapped(Vec3 point, const Bounds& bounds)
{
    const double cell = 1e-7 * bounds.diagonal();
    constexpr double offset = 0.1234567; // keeps the borders between grid points away from common coordinates
    const Vec3 scaled = (1.0 / cell) * (point - bounds.low);
    return {std::round(scaled.x + offset), std::round(scaled.y + offset), std::round(scaled.z + offset)};
}

LargeVector<std::uint32_t> weld(const LargeVector<Vec3>& vertices)
{
    std::size_t table_size = 16; // a power of two; the table stays less than half full
    while (table_size <= 2 * vertices.size())
        table_size *= 2;
    const std::size_t slot_mask = table_size - 1;

    // An entry is the index of a vertex and, in the bits above it, part of its hash, so that vertices with another hash
    // are rarely read.
    const std::uint64_t number_mask = table_size / 2 - 1;
    constexpr std::uint32_t empty = 0xffffffffu; // an index that no vertex has
    LargeVector<std::uint32_t> table(table_size, empty);
    const auto entry_of = [&](std::uint64_t hash, std::uint32_t i) {
        return static_cast<std::uint32_t>((hash >> 32 & ~number_mask) | i);
    };

    LargeVector<std::uint32_t> representative(vertices.size());
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        constexpr std::size_t ahead = 16; // prefetch distance
        if (i + ahead < vertices.size())
            prefetch(&table[hash_of(vertices[i + ahead]) & slot_mask]);
        representative[i] = i;
        const std::uint64_t hash = hash_of(vertices[i]);
        const std::uint32_t entry = entry_of(hash, i);
        std::size_t slot = hash & slot_mask;
        for (int step = 0; step < most_steps; ++step, slot = (slot + 1) & slot_mask) {
            if (table[slot] == empty) {
                table[slot] = entry;
                break;
            }
            const std::uint32_t other = table[slot] & static_cast<std::uint32_t>(number_mask);
            if (entry_of(hash, other) == table[slot] && vertices[other] == vertices[i]) {
                representative[i] = other;
                break;
            }
        }
    }
    return representative;
}

} // namespace multipath
