#pragma once

#include <cstdint>
#include <vector>

namespace multipath {

/// Box in single precision; the fourth components only fill, so that a compiler can use vectors of four.
struct SplitBox
{
    float low[4];
    float high[4];

    static SplitBox nothing();

    void include(const SplitBox& other)
    {
        for (int i = 0; i < 4; ++i)
            low[i] = other.low[i] < low[i] ? other.low[i] : low[i];
        for (int i = 0; i < 4; ++i)
            high[i] = other.high[i] > high[i] ? other.high[i] : high[i];
    }
    float area() const
    {
        const float x = high[0] - low[0];
        const float y = high[1] - low[1];
        const float z = high[2] - low[2];
        return 2.0f * (x * y + y * z + z * x);
    }
};

struct SplitThing
{
    SplitBox box;
    std::uint32_t number;
};

/// Sorts things first ... last - 1 into two parts, by the surface area heuristic over 16 bins along each axis, or into
/// halves where no split separates them. The beginning of the second part; neither is empty.
std::uint32_t split_by_area(std::vector<SplitThing>& things, std::uint32_t first, std::uint32_t last);

} // namespace multipath
