#pragma once

#include <array>

// What the paper prints (Castro, Martinez, Sbert 1998), to be set beside what the program finds.

namespace multipath {

/// A row of Table 1: the slopes of log MSE against log N.
struct PublishedSlope
{
    const char* sequence; ///< as --sequence names it
    double five_cubes;
    double four_chairs;
};

constexpr std::array<PublishedSlope, 3> published_slopes = {
    {{"halton:2,7,3,5", -1.098, -0.998}, {"halton:11,13,17,19", -0.844, -1.113}, {"sobol", -1.102, -1.122}}};

/// Section 4.2: what (3) takes, and what it gives.
struct PublishedBudget
{
    double average_reflectance;   ///< R_ave
    double secondary_reflectance; ///< R_s'
    double lit_fraction;          ///< f
    double intersections;         ///< n_int
    double ratio;                 ///< N_l / N_g
};

constexpr PublishedBudget published_up = {0.577, 0.7, 0.073, 2.1, 0.41};       ///< first shot, lit upwards
constexpr PublishedBudget published_down = {0.577, 0.65, 0.67, 2.1, 0.85};     ///< first shot, lit downwards
constexpr PublishedBudget published_extended = {0.577, 0.577, 1.0, 2.1, 1.06}; ///< extended first shot, both

} // namespace multipath
