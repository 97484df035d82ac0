// A block of patches i with areas A_i, radiosities B_i and variances s_i^2 is fitted by B~ = sum of q_k <q_k, B>, where
// <x, y> = sum of A_i x_i y_i, and q_1 ... q_p are orthonormal polynomials in the coordinates of the patches
// (Gram-Schmidt). The expected error of B~, sum of A_i (B~_i - truth_i)^2, is that of
//
//   sum of A_i (B~_i - B_i)^2 + 2 sum of A_i^2 s_i^2 l_i - sum of A_i s_i^2        (R6)
//
// where l_i = sum of q_k(i)^2 is the leverage of patch i: Stein's unbiased risk estimate. For patches that are not
// fitted, the last two sums are equal. A chosen fit is the best of many, so its estimated risk is too low; an empirical
// price above 2 for the middle sum compensates this (cost-complexity pruning, Breiman et al. 1984). The constant
// polynomial preserves the sum of A_i B_i.

#include "radiosity/reuse/denoising.h"

#include "base/lists.h"
#include "base/memory.h"
#include "parallel/blocks.h"
#include "radiosity/reuse/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace multipath {

namespace {

constexpr int tree_count = 4;
constexpr double price = 2.5;
constexpr std::size_t most_degree = 2;
constexpr std::uint32_t most_of_block = 1024; // larger blocks would not reduce the noise noticeably
constexpr std::uint32_t least_of_block = 8; // not cut further: noise would decide which few patches are fitted together

constexpr std::size_t most_polynomials = 1 + dimensions_of_place + 6;

double sum(Rgb x)
{
    return x.r + x.g + x.b;
}

/// Sum of a_k b_k, in four partial sums for vector instructions.
double sum_of_products(const double* a, const double* b, std::size_t count)
{
    constexpr std::size_t lanes = 4;
    std::array<double, lanes> sums{};
    const std::size_t whole = count - count % lanes;
    for (std::size_t k = 0; k < whole; k += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            sums[lane] += a[k + lane] * b[k + lane];
    for (std::size_t k = whole; k < count; ++k)
        sums[k - whole] += a[k] * b[k];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// What is to be denoised. Patches have the normals of their surfaces, on both sides.
struct NoisyLight
{
    const Scene& scene;
    const std::vector<Rgb>& radiosity;
    const std::vector<Rgb>& variance;
    std::vector<Place> surfaces = {}; ///< their centres and normals
    std::vector<Place> patches = {};

    const Place& surface_of(std::uint32_t patch) const { return surfaces[scene.surface_of(patch)]; }
    /// Key of the material and the side of a patch.
    std::uint32_t group(std::uint32_t i) const
    {
        return 2 * scene.file().material[scene.surface_of(i)] + (scene.is_front(i) ? 0 : 1);
    }
};

NoisyLight placed(NoisyLight light)
{
    constexpr double turn = 0.1; // a unit difference of normals counts like this fraction of the diagonal
    const Scene& scene = light.scene;
    for (const Surface& surface : scene.surfaces())
        light.surfaces.push_back(place_of(surface.centre(), turn * scene.bounds().diagonal() * surface.normal()));
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Place& surface = light.surface_of(i);
        light.patches.push_back(place_of(scene.patch(i).shape.centre(), {surface[3], surface[4], surface[5]}));
    }
    return light;
}

/// A least-squares fit to a block of patches, to which polynomials are added one by one.
class Fit
{
public:
    struct Member
    {
        std::uint32_t patch;
        double area;
        Rgb found;             ///< B
        Rgb noise;             ///< s^2
        Rgb value = {};        ///< B~
        double leverage = 0.0; ///< l
    };

    /// Begins a fit to the patches first ... last - 1, one at least.
    Fit(const NoisyLight& light, const std::uint32_t* first, const std::uint32_t* last)
        : count_(static_cast<std::size_t>(last - first)), polynomial_(count_), weighted_(count_)
    {
        Extent<Place> box(light.patches[*first]);
        for (const std::uint32_t* i = first; i != last; ++i)
            box.include(light.patches[*i]);
        const double width = box.length(box.longest());
        const double scale = width > 0.0 ? 2.0 / width : 0.0;
        const Scene& scene = light.scene;
        const bool one_surface = scene.surface_of(*first) == scene.surface_of(last[-1]);
        const Surface& surface = scene.surfaces()[scene.surface_of(*first)];
        const Vec3 along_u = normalized(surface.edge_u);
        const Vec3 across = cross(surface.normal(), along_u);
        linear_ = one_surface ? 2 : dimensions_of_place;
        squared_ = one_surface ? 2 : 3;
        at_.assign((1 + linear_) * count_, 1.0);
        basis_.reserve(most_polynomials * count_);
        members_.reserve(count_);
        for (const std::uint32_t* i = first; i != last; ++i) {
            Place x = light.patches[*i];
            for (std::size_t d = 0; d < x.size(); ++d)
                x[d] = scale * (x[d] - 0.5 * (box.low[d] + box.high[d]));
            if (one_surface) {
                const Vec3 p = {x[0], x[1], x[2]};
                x = {dot(p, along_u), dot(p, across)};
            }
            for (std::size_t d = 0; d < linear_; ++d)
                at_[(1 + d) * count_ + members_.size()] = x[d];
            members_.push_back({*i, scene.area(*i), light.radiosity[*i], light.variance[*i]});
            total_area_ += members_.back().area;
        }
    }

    /// Adds all polynomials of this degree, 0, 1 or 2; those of lower degrees must be there. Normals have linear
    /// polynomials only. Returns false if the fit would have more parameters than half the number of patches.
    bool add_degree(std::size_t degree)
    {
        const std::size_t coordinates = degree == 0 ? 0 : degree == 1 ? linear_ : squared_;
        for (std::size_t d = degree > 0 ? 1 : 0; d <= coordinates; ++d)
            for (std::size_t e = degree > 1 ? 1 : 0; e <= (degree > 1 ? d : 0); ++e) {
                for (std::size_t k = 0; k < count_; ++k)
                    polynomial_[k] = at_[d * count_ + k] * at_[e * count_ + k];
                if (!add())
                    return false;
            }
        return true;
    }

    const std::vector<Member>& members() const { return members_; }
    double total_area() const { return total_area_; }

private:
    /// Orthogonalises the polynomial against the basis (Gram-Schmidt), and adds it to basis and fit. A polynomial that
    /// depends on the others has no effect. Returns false if the basis is as large as allowed.
    bool add()
    {
        for (std::size_t k = 0; k < count_; ++k)
            weighted_[k] = members_[k].area * polynomial_[k];
        double square = sum_of_products(weighted_.data(), polynomial_.data(), count_);
        const std::size_t used = basis_.size() / count_;
        std::array<double, most_polynomials> products{};
        for (std::size_t b = 0; b < used; ++b) {
            products[b] = sum_of_products(weighted_.data(), &basis_[b * count_], count_);
            square -= products[b] * products[b];
        }
        constexpr double tiny =
            1e-6; // of its square: the rest is rounding, as if all patches lie in a plane or on a line
        if (!(square > tiny * total_area_))
            return true;
        if (2 * (used + 1) > count_)
            return false;
        const double norm = 1.0 / std::sqrt(square);
        for (const double x : polynomial_)
            basis_.push_back(norm * x);
        double* const q = &basis_[used * count_];
        for (std::size_t b = 0; b < used; ++b)
            for (std::size_t k = 0; k < count_; ++k)
                q[k] -= norm * products[b] * basis_[b * count_ + k];
        Rgb share;
        for (std::size_t k = 0; k < count_; ++k)
            share += (members_[k].area * q[k]) * members_[k].found;
        for (std::size_t k = 0; k < count_; ++k) {
            members_[k].value += q[k] * share;
            members_[k].leverage += q[k] * q[k];
        }
        return true;
    }

    const std::size_t count_; ///< number of patches
    std::vector<Member> members_;
    double total_area_ = 0.0;
    std::size_t linear_;             ///< number of coordinates with linear polynomials
    std::size_t squared_;            ///< number of coordinates with quadratic polynomials
    std::vector<double> at_;         ///< for all patches: 1, then each coordinate, scaled to about -1 ... 1
    std::vector<double> polynomial_; ///< the next one to add
    std::vector<double> weighted_;   ///< area times polynomial
    std::vector<double> basis_;      ///< for all patches: each q
};

/// The sums of (R6) for a fit [W^2/m^2].
struct Residual
{
    Rgb found; ///< sum of A_i (B~_i - B_i)^2
    Rgb noise; ///< sum of A_i s_i^2
    Rgb trace; ///< sum of A_i^2 s_i^2 l_i

    explicit Residual(const Fit& fit)
    {
        for (const Fit::Member& m : fit.members()) {
            const Rgb difference = m.found - m.value;
            const Rgb of_patch = m.area * m.noise;
            found += m.area * (difference * difference);
            noise += of_patch;
            trace += (m.area * m.leverage) * of_patch;
        }
    }
    double risk() const { return sum(found) + price * sum(trace) - sum(noise); }
};

/// A tree of blocks of patches, which is pruned to the fits of least risk.
struct FittedTree
{
    const NoisyLight& light;
    std::vector<std::uint32_t> order; ///< patches with variance, sorted by group, then by surface; later in tree order
    double shift;                     ///< relative position of the first cuts, 0 ... 1
    std::vector<Rgb>& radiosity;
    std::vector<Rgb>& variance;

    /// Sets the radiosity and the variance of all patches that are fitted.
    void fit(int threads)
    {
        std::vector<Block> blocks;
        const auto count = static_cast<std::uint32_t>(order.size());
        for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
            const std::uint32_t group = light.group(order[begin]);
            while (end < count && light.group(order[end]) == group)
                ++end;
            divide({begin, end, 0}, blocks);
        }
        parallel_blocks(blocks.size(), threads, [&](std::uint64_t b) { prune(blocks[static_cast<std::size_t>(b)]); });
    }

    /// A range of consecutive patches in tree order.
    struct Block
    {
        std::uint32_t begin;
        std::uint32_t end;
        int cuts; ///< number of cuts within its surface that led to it
    };

    void divide(Block block, std::vector<Block>& blocks)
    {
        const std::vector<Block> halves = split(block, most_of_block);
        for (const Block& half : halves)
            divide(half, blocks);
        if (halves.empty())
            blocks.push_back(block);
    }

    /// Cuts a block of more than `most` patches across its longest extent, between surfaces if it has several,
    /// otherwise within its surface. Empty if all positions are the same.
    std::vector<Block> split(Block block, std::uint32_t most)
    {
        if (block.end - block.begin <= most)
            return {};
        const Scene& scene = light.scene;
        const auto first = order.begin() + block.begin;
        const auto last = order.begin() + block.end;
        const bool one = scene.surface_of(*first) == scene.surface_of(last[-1]);
        const auto place = [&](std::uint32_t i) -> const Place& {
            return one ? light.patches[i] : light.surface_of(i);
        };
        Extent<Place> box(place(*first));
        std::for_each(first, last, [&](std::uint32_t i) { box.include(place(i)); });
        const std::size_t d = box.longest();
        constexpr int shifted_cuts = 2;
        const double at = box.low[d] + (block.cuts < shifted_cuts ? shift : 0.5) * box.length(d);
        if (!(at > box.low[d]))
            return {};
        const auto second = std::stable_partition(first, last, [&](std::uint32_t i) { return place(i)[d] < at; });
        const auto middle = static_cast<std::uint32_t>(second - order.begin());
        const int cuts = block.cuts + (one ? 1 : 0);
        return {{block.begin, middle, cuts}, {middle, block.end, cuts}};
    }

    /// Fits the two parts of a block, or the whole block if that has less risk. Returns the estimated risk.
    double prune(Block block)
    {
        const std::vector<Block> halves = split(block, least_of_block);
        double risk = sum_over(halves, [this](const Block& half) { return prune(half); });
        if (halves.empty())
            for (std::uint32_t k = block.begin; k < block.end; ++k)
                risk += (price - 1.0) * light.scene.area(order[k]) * sum(light.variance[order[k]]);
        if (block.end - block.begin == 1)
            return risk;
        Fit fit(light, order.data() + block.begin, order.data() + block.end);
        for (std::size_t degree = 0; degree <= most_degree && fit.add_degree(degree); ++degree) {
            const Residual residual(fit);
            if (!(residual.risk() < risk) || !is_sound(fit, residual))
                continue;
            risk = residual.risk();
            take(fit, residual);
        }
        return risk;
    }

    /// False for a fit that makes a patch darker than its emittance, or changes it more than noise can explain.
    bool is_sound(const Fit& fit, const Residual& residual) const
    {
        constexpr double far = 6.0;    // standard deviations
        constexpr double least = 0.01; // of the variance of the others: the few rays of a patch may have none
        const double usual = sum(residual.noise) / fit.total_area();
        return std::all_of(fit.members().begin(), fit.members().end(), [&](const Fit::Member& m) {
            const Rgb difference = m.found - m.value;
            return at_most(light.scene.emittance(m.patch), m.value) &&
                   !(sum(difference * difference) > far * far * std::max(sum(m.noise), least * usual));
        });
    }

    /// Replaces the patches by the fit. Their variance is the part of the noise that the fit retains, plus the
    /// estimated squared bias of the fit.
    void take(const Fit& fit, const Residual& residual)
    {
        const auto excess = [](double x, double y) { return std::max(0.0, x - y); };
        const Rgb bias = 1.0 / fit.total_area() * by_channel(excess, residual.found + residual.trace, residual.noise);
        Rgb noise;
        for (const Fit::Member& m : fit.members())
            noise += m.area * m.area / fit.total_area() * m.noise;
        for (const Fit::Member& m : fit.members()) {
            radiosity[m.patch] = m.value;
            variance[m.patch] = m.leverage * noise + bias;
        }
    }
};

/// [1] Reflectance of each patch divided by that of its material; empty without textures.
std::vector<Rgb> texture_detail(const Scene& scene)
{
    if (scene.file().textures.empty())
        return {};
    constexpr double least = 1e-3; // the light of black patches needs no smoothing
    const auto ratio = [](double a, double b) { return b > 0.0 && a > least * b ? a / b : 1.0; };
    return serial_list(scene.patch_count(), [&](std::uint32_t i) {
        return by_channel(ratio, scene.reflectance(i), scene.material_of(i).reflectance);
    });
}

} // namespace

void denoise(const Scene& scene, int threads, std::vector<Rgb>& radiosity, std::vector<Rgb>& variance)
{
    // Sunlight has no noise, and its shadows have sharp edges, like textures; so both are removed before the fit.
    const auto sunlight = [&](std::uint32_t i) { return scene.reflectance(i) * scene.sunlight(i); };
    const std::vector<Rgb> detail = texture_detail(scene);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        radiosity[i] = radiosity[i] - sunlight(i);
    for (std::uint32_t i = 0; i < detail.size(); ++i) {
        radiosity[i] = scene.emittance(i) + quotient(radiosity[i] - scene.emittance(i), detail[i]);
        variance[i] = quotient(variance[i], detail[i] * detail[i]);
    }
    const NoisyLight light = placed({scene, radiosity, variance});
    std::vector<std::uint32_t> patches;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (sum(variance[i]) > 0.0)
            patches.push_back(i);
    std::stable_sort(patches.begin(), patches.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return light.group(i) < light.group(j); });
    std::vector<Rgb> mean_radiosity = large_vector<Rgb>(radiosity.size());
    std::vector<Rgb> mean_variance = large_vector<Rgb>(radiosity.size());
    for (int tree = 0; tree < tree_count; ++tree) {
        std::vector<Rgb> fitted = radiosity;
        std::vector<Rgb> noise = variance;
        FittedTree{light, patches, 0.25 + 0.5 * (tree + 0.5) / tree_count, fitted, noise}.fit(threads);
        parallel_numbers(scene.patch_count(), threads, [&](std::uint32_t i) {
            mean_radiosity[i] += 1.0 / tree_count * fitted[i];
            mean_variance[i] += 1.0 / tree_count * noise[i];
        });
    }
    for (std::uint32_t i = 0; i < detail.size(); ++i) {
        mean_radiosity[i] = scene.emittance(i) + detail[i] * (mean_radiosity[i] - scene.emittance(i));
        mean_variance[i] = detail[i] * detail[i] * mean_variance[i];
    }
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        mean_radiosity[i] += sunlight(i);
    radiosity = std::move(mean_radiosity);
    variance = std::move(mean_variance);
}

} // namespace multipath
