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

#include "base/memory.h"
#include "parallel/blocks.h"

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
constexpr int most_degree = 2;
constexpr std::uint32_t most_of_block = 1024; // larger blocks would not reduce the noise noticeably
constexpr std::uint32_t least_of_block = 8; // not cut further: noise would decide which few patches are fitted together

constexpr std::size_t coordinate_count = 6; // position and normal
constexpr std::size_t most_polynomials = 1 + coordinate_count + 6;
using Coordinates = std::array<double, coordinate_count>;

double sum(Rgb x)
{
    return x.r + x.g + x.b;
}

struct Extent
{
    Coordinates low;
    Coordinates high;

    /// Bounding box of the coordinates of patches; there must be at least one.
    template <class CoordinatesOf>
    Extent(const std::uint32_t* first, const std::uint32_t* last, const CoordinatesOf& of) : low(of(*first)), high(low)
    {
        for (const std::uint32_t* patch = first; patch != last; ++patch) {
            const Coordinates point = of(*patch);
            for (std::size_t d = 0; d < coordinate_count; ++d) {
                low[d] = std::min(low[d], point[d]);
                high[d] = std::max(high[d], point[d]);
            }
        }
    }

    double length(std::size_t d) const { return high[d] - low[d]; }
    std::size_t longest() const
    {
        std::size_t result = 0;
        for (std::size_t d = 1; d < coordinate_count; ++d)
            if (length(d) > length(result))
                result = d;
        return result;
    }
};

/// Coordinates of the patches.
class PatchCoordinates
{
public:
    explicit PatchCoordinates(const Scene& scene)
        : scene_(scene),
          surfaces_(vector_with_capacity<Coordinates>(scene.surfaces().size())),
          centres_(vector_with_capacity<Vec3>(scene.patch_count()))
    {
        constexpr double turn = 0.1; // a unit difference of normals counts like this fraction of the diagonal
        for (const Surface& surface : scene.surfaces()) {
            const Vec3 centre = surface.centre();
            const Vec3 normal = turn * scene.bounds().diagonal() * surface.normal();
            surfaces_.push_back({centre.x, centre.y, centre.z, normal.x, normal.y, normal.z});
        }
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            centres_.push_back(scene.patch(i).shape.centre());
    }

    Coordinates of_surface(std::uint32_t patch) const { return surfaces_[scene_.surface_of(patch)]; }
    Coordinates of_patch(std::uint32_t patch) const
    {
        Coordinates result = of_surface(patch);
        result[0] = centres_[patch].x;
        result[1] = centres_[patch].y;
        result[2] = centres_[patch].z;
        return result;
    }

private:
    const Scene& scene_;
    std::vector<Coordinates> surfaces_;
    std::vector<Vec3> centres_;
};

/// Sum of a_k b_k, in four partial sums for vector instructions.
double sum_of_products(const std::vector<double>& a, const std::vector<double>& b)
{
    constexpr std::size_t lanes = 4;
    std::array<double, lanes> sums{};
    const std::size_t whole = a.size() - a.size() % lanes;
    for (std::size_t k = 0; k < whole; k += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            sums[lane] += a[k + lane] * b[k + lane];
    for (std::size_t k = whole; k < a.size(); ++k)
        sums[k - whole] += a[k] * b[k];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// A least-squares fit to a block of patches, to which polynomials are added one by one.
class Fit
{
public:
    Fit(const Scene& scene, const PatchCoordinates& coordinates, const std::vector<Rgb>& radiosity,
        const std::vector<Rgb>& variance)
        : scene_(scene), coordinates_(coordinates), radiosity_(radiosity), variance_(variance)
    {
    }

    void begin(const std::uint32_t* first, const std::uint32_t* last)
    {
        patches_ = first;
        count_ = static_cast<std::size_t>(last - first);
        const Extent box(first, last, [&](std::uint32_t i) { return coordinates_.of_patch(i); });
        const double width = box.length(box.longest());
        const double scale = width > 0.0 ? 2.0 / width : 0.0;
        for (std::vector<double>& x : at_)
            x.resize(count_);
        area_.resize(count_);
        total_area_ = 0.0;
        const bool one_surface = scene_.surface_of(*first) == scene_.surface_of(last[-1]);
        const Surface& surface = scene_.surfaces()[scene_.surface_of(*first)];
        const Vec3 along_u = normalized(surface.edge_u);
        const Vec3 across = cross(surface.normal(), along_u);
        for (std::size_t k = 0; k < count_; ++k) {
            Coordinates x = coordinates_.of_patch(first[k]);
            for (std::size_t d = 0; d < coordinate_count; ++d)
                x[d] = scale * (x[d] - 0.5 * (box.low[d] + box.high[d]));
            if (one_surface) {
                const Vec3 p = {x[0], x[1], x[2]};
                x = {dot(p, along_u), dot(p, across), 0.0, 0.0, 0.0, 0.0};
            }
            for (std::size_t d = 0; d < coordinate_count; ++d)
                at_[d][k] = x[d];
            area_[k] = scene_.area(first[k]);
            total_area_ += area_[k];
        }
        linear_ = one_surface ? 2 : coordinate_count;
        squared_ = one_surface ? 2 : 3;
        value_.assign(count_, {});
        leverage_.assign(count_, 0.0);
        used_ = 0;
    }

    /// Adds all polynomials of this degree; those of lower degrees must be there. Normals have linear polynomials only.
    /// Returns false if the fit would have more parameters than half the number of patches.
    bool add_degree(int degree)
    {
        if (degree == 0) {
            polynomial_.assign(count_, 1.0);
            return add();
        }
        if (degree == 1) {
            for (std::size_t d = 0; d < linear_; ++d) {
                polynomial_ = at_[d];
                if (!add())
                    return false;
            }
            return true;
        }
        for (std::size_t d = 0; d < squared_; ++d)
            for (std::size_t e = 0; e <= d; ++e) {
                for (std::size_t k = 0; k < count_; ++k)
                    polynomial_[k] = at_[d][k] * at_[e][k];
                if (!add())
                    return false;
            }
        return true;
    }

    std::size_t size() const { return count_; }
    double total_area() const { return total_area_; }
    std::uint32_t patch(std::size_t k) const { return patches_[k]; }
    double area(std::size_t k) const { return area_[k]; }
    Rgb found(std::size_t k) const { return radiosity_[patches_[k]]; } ///< B
    Rgb noise(std::size_t k) const { return variance_[patches_[k]]; }  ///< s^2
    Rgb value(std::size_t k) const { return value_[k]; }               ///< B~
    double leverage(std::size_t k) const { return leverage_[k]; }      ///< l

private:
    /// Orthogonalises the polynomial against the basis (Gram-Schmidt), and adds it to basis and fit. A polynomial that
    /// depends on the others has no effect. Returns false if the basis is as large as allowed.
    bool add()
    {
        weighted_.resize(count_);
        for (std::size_t k = 0; k < count_; ++k)
            weighted_[k] = area_[k] * polynomial_[k];
        double square = sum_of_products(weighted_, polynomial_);
        std::array<double, most_polynomials> products{};
        for (std::size_t b = 0; b < used_; ++b) {
            products[b] = sum_of_products(weighted_, basis_[b]);
            square -= products[b] * products[b];
        }
        constexpr double tiny =
            1e-6; // of its square: the rest is rounding, as if all patches lie in a plane or on a line
        if (!(square > tiny * total_area_))
            return true;
        if (2 * (used_ + 1) > count_)
            return false;
        const double norm = 1.0 / std::sqrt(square);
        std::vector<double>& q = basis_[used_];
        q.resize(count_);
        for (std::size_t k = 0; k < count_; ++k)
            q[k] = norm * polynomial_[k];
        for (std::size_t b = 0; b < used_; ++b)
            for (std::size_t k = 0; k < count_; ++k)
                q[k] -= norm * products[b] * basis_[b][k];
        Rgb share;
        for (std::size_t k = 0; k < count_; ++k)
            share += (area_[k] * q[k]) * found(k);
        for (std::size_t k = 0; k < count_; ++k) {
            value_[k] += q[k] * share;
            leverage_[k] += q[k] * q[k];
        }
        ++used_;
        return true;
    }

    const Scene& scene_;
    const PatchCoordinates& coordinates_;
    const std::vector<Rgb>& radiosity_;
    const std::vector<Rgb>& variance_;
    const std::uint32_t* patches_ = nullptr;
    std::size_t count_ = 0;
    double total_area_ = 0.0;
    std::array<std::vector<double>, coordinate_count>
        at_;                  ///< scaled to about -1 ... 1; within one surface only the first two
    std::size_t linear_ = 0;  ///< number of coordinates with linear polynomials
    std::size_t squared_ = 0; ///< number of coordinates with quadratic polynomials
    std::vector<double> area_;
    std::vector<double> polynomial_;                          ///< the next one to add
    std::vector<double> weighted_;                            ///< area times polynomial
    std::array<std::vector<double>, most_polynomials> basis_; ///< q; the first used_ are valid
    std::size_t used_ = 0;
    std::vector<Rgb> value_;
    std::vector<double> leverage_;
};

/// The sums of (R6) for a fit [W^2/m^2].
struct Residual
{
    Rgb found; ///< sum of A_i (B~_i - B_i)^2
    Rgb noise; ///< sum of A_i s_i^2
    Rgb trace; ///< sum of A_i^2 s_i^2 l_i
    double risk() const { return sum(found) + price * sum(trace) - sum(noise); }
};

class Denoising
{
public:
    Denoising(const Scene& scene, int threads, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& variance)
        : scene_(scene), coordinates_(scene), threads_(threads), radiosity_(radiosity), variance_(variance)
    {
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            if (sum(variance[i]) > 0.0)
                patches_.push_back(i);
        std::stable_sort(patches_.begin(), patches_.end(),
                         [&](std::uint32_t i, std::uint32_t j) { return group(i) < group(j); });
    }

    /// Fits the blocks of one tree: sets `radiosity` and `variance` of all patches that are fitted.
    void fit_tree(int number, std::vector<Rgb>& radiosity, std::vector<Rgb>& variance)
    {
        order_ = patches_;
        shift_ = 0.25 + 0.5 * (number + 0.5) / tree_count;
        std::vector<Block> blocks;
        const auto count = static_cast<std::uint32_t>(patches_.size());
        for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
            while (end < count && group(patches_[end]) == group(patches_[begin]))
                ++end;
            divide({begin, end, 0}, blocks);
        }
        parallel_blocks(blocks.size(), threads_, [&](std::uint64_t b) {
            Fit fit(scene_, coordinates_, radiosity_, variance_);
            prune(blocks[static_cast<std::size_t>(b)], fit, radiosity, variance);
        });
    }

private:
    /// A range of consecutive patches in tree order.
    struct Block
    {
        std::uint32_t begin;
        std::uint32_t end;
        int cuts; ///< number of cuts within its surface that led to it

        std::uint32_t size() const { return end - begin; }
    };

    /// Key of the material and the side of a patch.
    std::uint32_t group(std::uint32_t i) const
    {
        return 2 * scene_.file().material[scene_.surface_of(i)] + (scene_.is_front(i) ? 0 : 1);
    }

    static Residual residual_of(const Fit& fit)
    {
        Residual result;
        for (std::size_t k = 0; k < fit.size(); ++k) {
            const Rgb difference = fit.found(k) - fit.value(k);
            const Rgb noise = fit.area(k) * fit.noise(k);
            result.found += fit.area(k) * (difference * difference);
            result.noise += noise;
            result.trace += (fit.area(k) * fit.leverage(k)) * noise;
        }
        return result;
    }

    void divide(Block block, std::vector<Block>& blocks)
    {
        const std::vector<Block> halves = block.size() > most_of_block ? split(block) : std::vector<Block>();
        for (const Block& half : halves)
            divide(half, blocks);
        if (halves.empty())
            blocks.push_back(block);
    }

    /// Cuts a block across its longest extent, between surfaces if it has several, otherwise within its surface. Empty
    /// if all positions are the same.
    std::vector<Block> split(Block block)
    {
        const std::uint32_t* const first = order_.data() + block.begin;
        const std::uint32_t* const last = order_.data() + block.end;
        const bool one = scene_.surface_of(*first) == scene_.surface_of(last[-1]);
        const auto coordinates = [&](std::uint32_t i) {
            return one ? coordinates_.of_patch(i) : coordinates_.of_surface(i);
        };
        const Extent box(first, last, coordinates);
        const std::size_t d = box.longest();
        constexpr int shifted_cuts = 2;
        const double at = box.low[d] + (block.cuts < shifted_cuts ? shift_ : 0.5) * box.length(d);
        if (!(at > box.low[d]))
            return {};
        const auto second = std::stable_partition(order_.begin() + block.begin, order_.begin() + block.end,
                                                  [&](std::uint32_t i) { return coordinates(i)[d] < at; });
        const auto middle = static_cast<std::uint32_t>(second - order_.begin());
        const int cuts = block.cuts + (one ? 1 : 0);
        return {{block.begin, middle, cuts}, {middle, block.end, cuts}};
    }

    /// Fits the two parts of a block, or the whole block if that has less risk. Returns the estimated risk.
    double prune(Block block, Fit& fit, std::vector<Rgb>& radiosity, std::vector<Rgb>& variance)
    {
        const std::vector<Block> halves = block.size() > least_of_block ? split(block) : std::vector<Block>();
        double risk = 0.0;
        for (const Block& half : halves)
            risk += prune(half, fit, radiosity, variance);
        if (halves.empty())
            for (std::uint32_t k = block.begin; k < block.end; ++k)
                risk += (price - 1.0) * scene_.area(order_[k]) * sum(variance_[order_[k]]);
        if (block.size() == 1)
            return risk;
        fit.begin(order_.data() + block.begin, order_.data() + block.end);
        for (int degree = 0; degree <= most_degree && fit.add_degree(degree); ++degree) {
            const Residual residual = residual_of(fit);
            if (!(residual.risk() < risk) || !is_sound(fit, residual))
                continue;
            risk = residual.risk();
            take(fit, residual, radiosity, variance);
        }
        return risk;
    }

    /// False for a fit that makes a patch darker than its emittance, or changes it more than noise can explain.
    bool is_sound(const Fit& fit, const Residual& residual) const
    {
        constexpr double far = 6.0;    // standard deviations
        constexpr double least = 0.01; // of the variance of the others: the few rays of a patch may have none
        const double usual = sum(residual.noise) / fit.total_area();
        for (std::size_t k = 0; k < fit.size(); ++k) {
            const Rgb difference = fit.found(k) - fit.value(k);
            if (!at_most(scene_.emittance(fit.patch(k)), fit.value(k)) ||
                sum(difference * difference) > far * far * std::max(sum(fit.noise(k)), least * usual))
                return false;
        }
        return true;
    }

    /// Replaces the patches by the fit. Their variance is the part of the noise that the fit retains, plus the
    /// estimated squared bias of the fit.
    void take(const Fit& fit, const Residual& residual, std::vector<Rgb>& radiosity, std::vector<Rgb>& variance) const
    {
        const auto excess = [](double x, double y) { return std::max(0.0, x - y); };
        const Rgb bias = 1.0 / fit.total_area() * by_channel(excess, residual.found + residual.trace, residual.noise);
        Rgb noise;
        for (std::size_t k = 0; k < fit.size(); ++k)
            noise += fit.area(k) * fit.area(k) / fit.total_area() * fit.noise(k);
        for (std::size_t k = 0; k < fit.size(); ++k) {
            radiosity[fit.patch(k)] = fit.value(k);
            variance[fit.patch(k)] = fit.leverage(k) * noise + bias;
        }
    }

    const Scene& scene_;
    const PatchCoordinates coordinates_;
    const int threads_;
    const std::vector<Rgb>& radiosity_;
    const std::vector<Rgb>& variance_;
    std::vector<std::uint32_t> patches_; ///< patches with variance, sorted by group, then by surface
    std::vector<std::uint32_t> order_;   ///< patches in the order of the current tree
    double shift_ = 0.0;                 ///< relative position of its first cuts, 0 ... 1
};

/// [1] Reflectance of each patch divided by that of its material; empty without textures.
std::vector<Rgb> texture_detail(const Scene& scene)
{
    std::vector<Rgb> result;
    if (scene.file().textures.empty())
        return result;
    constexpr double least = 1e-3; // the light of black patches needs no smoothing
    const auto ratio = [](double a, double b) { return b > 0.0 && a > least * b ? a / b : 1.0; };
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        result.push_back(by_channel(ratio, scene.reflectance(i), scene.material_of(i).reflectance));
    return result;
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
    Denoising denoising(scene, threads, radiosity, variance);
    std::vector<Rgb> mean_radiosity = large_vector<Rgb>(radiosity.size());
    std::vector<Rgb> mean_variance = large_vector<Rgb>(radiosity.size());
    for (int tree = 0; tree < tree_count; ++tree) {
        std::vector<Rgb> fitted = radiosity;
        std::vector<Rgb> noise = variance;
        denoising.fit_tree(tree, fitted, noise);
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
