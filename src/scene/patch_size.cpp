#include "scene/patch_size.h"

#include "geometry/surface_boxes.h"
#include "scene/tessellation.h"

#include <array>
#include <cmath>

namespace multipath {

namespace {

/// 1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten: number k of these sizes, 10 to a decade.
double round_size(int k)
{
    constexpr std::array<double, 10> mantissas = {1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    const int exponent = k >= 0 ? k / 10 : -((9 - k) / 10);
    const double mantissa = mantissas[static_cast<std::size_t>(k - 10 * exponent)];
    return exponent < 0 ? mantissa / std::pow(10.0, -exponent) : mantissa * std::pow(10.0, exponent);
}

double total_area(const std::vector<Surface>& surfaces)
{
    double area = 0.0;
    for (const Surface& surface : surfaces)
        area += surface.area();
    return area;
}

/// Every surface has at least one.
bool has_more_cells(const std::vector<Surface>& surfaces, double patch_size, std::uint64_t count)
{
    return surfaces.size() > count || cell_count(surfaces, patch_size) > static_cast<double>(count);
}

} // namespace

double default_patch_size(const std::vector<Surface>& surfaces)
{
    const double wanted = std::sqrt(total_area(surfaces) / 2500.0);
    int k = 10 * static_cast<int>(std::floor(std::log10(wanted)));
    while (round_size(k + 1) <= wanted)
        ++k;
    // Long or many triangles give more cells than their area says.
    constexpr std::uint64_t most = 4000;
    while (round_size(k + 1) <= 3.0 * wanted && has_more_cells(surfaces, round_size(k), most))
        ++k;
    // Slivers by the thousand are left almost whole.
    const std::uint64_t bearable = (1u << 17) + 8 * surfaces.size();
    while (has_more_cells(surfaces, round_size(k), bearable))
        ++k;
    return round_size(k);
}

double patch_size_for_count(const std::vector<Surface>& surfaces, std::uint64_t wanted)
{
    // The count falls with the size: bisection between squares of half the mean area, or less, and no cut at all.
    double too_small = 0.5 * std::sqrt(total_area(surfaces) / static_cast<double>(wanted));
    double enough = bounds_of(surfaces).diagonal();
    for (int step = 0; step < 50 && enough > too_small; ++step) {
        const double middle = 0.5 * (too_small + enough);
        (has_more_cells(surfaces, middle, wanted) ? too_small : enough) = middle;
    }
    return enough;
}

} // namespace multipath
