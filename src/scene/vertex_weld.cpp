#include "scene/vertex_weld.h"

#include <cstring>

namespace multipath {

namespace {

/// A file made to collide everywhere must not make us slow: past this many steps a vertex stands for itself.
constexpr int most_steps = 64;

std::uint64_t bits_of(double coordinate)
{
    const double without_negative_zero = coordinate + 0.0;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &without_negative_zero, sizeof bits);
    return bits;
}

/// All bits of the result depend on both.
std::uint64_t mix(std::uint64_t hash, std::uint64_t value)
{
    hash = (hash ^ value) * 0x9e3779b97f4a7c15u; // 2^64 / golden ratio
    return hash ^ (hash >> 32);
}

std::uint64_t hash_of(Vec3 p)
{
    return mix(mix(mix(0, bits_of(p.x)), bits_of(p.y)), bits_of(p.z));
}

} // namespace

std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices)
{
    constexpr std::uint32_t empty = 0xffffffffu;
    std::size_t table_size = 16; // a power of two, at most half full
    while (table_size < 2 * vertices.size())
        table_size *= 2;
    std::vector<std::uint32_t> table(table_size, empty);
    const std::size_t mask = table.size() - 1;

    std::vector<std::uint32_t> representative(vertices.size());
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        representative[i] = i;
        std::size_t slot = static_cast<std::size_t>(hash_of(vertices[i])) & mask;
        for (int step = 0; step < most_steps; ++step, slot = (slot + 1) & mask) {
            if (table[slot] == empty) {
                table[slot] = i;
                break;
            }
            if (vertices[table[slot]] == vertices[i]) {
                representative[i] = table[slot];
                break;
            }
        }
    }
    return representative;
}

} // namespace multipath
