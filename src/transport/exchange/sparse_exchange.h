#pragma once

#include "transport/exchange/exchange.h"
#include "transport/exchange/line_counts.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace multipath {

/// Exchange areas (exchange.h) estimated from counts of rays ((R4) in docs/equations.md), closed so that light is
/// conserved: symmetric, nowhere negative but for rounding, and with row sums equal to the areas of the patches. A row
/// sum here includes the losses (escaping and behind). With d_i rays per m^2 of patch i, and C_ij rays between i and j,
/// started at either end, the estimate of A_i F_ij is C_ij / (d_i + d_j): the balance heuristic of Veach and Guibas
/// (1995), which is never much worse than the best combination of the two kinds of rays. What is lost is known from
/// the patch's own rays (LossCounts), the fraction of them that reached no patch, unless the patches around cast far
/// more rays or nearly all rays are lost: then the rays that join the patch count as well.
/// Two steps close the estimate:
///
/// Step 1: G_ij = x_i x_j C_ij / (d_i + d_j), with one factor x per patch, by symmetric matrix balancing after Sinkhorn
/// and Knopp (1967). The factors remove the noise of how many rays of other patches happened to meet each patch.
/// Patches that cast fewer rays than those around them are scaled less. After the step no row sum exceeds the area of
/// the patch.
///
/// Step 2: The deficit delta_i, the area of patch i minus its row sum, is exchange that no ray has sampled. It is
/// divided like the patch's own rays: a part escapes or arrives behind surfaces, the rest is spread over the patches
/// with a deficit in the same space: sides of surfaces that rays join directly or through others. G_ij grows by
/// delta_i delta_j / sum of delta. So nothing gets into a space that no ray has entered. With tens of rays per patch
/// this is a small part of the whole (unseen_share()). A deficit from rounding alone becomes self-exchange instead, so
/// that no light gets into closed spaces.
///
/// If the scene has a sky, all that escapes reaches it. Its patches cast no rays: what they exchange with the other
/// patches is known from these, and the rest of their area is exchange with themselves. So the irradiance from a sky is
/// exact if all rays of a patch reach it.
class SparseExchange : public Exchange
{
public:
    /// Rays that left a patch, and those of them that escaped or met a side without a patch.
    struct LossCounts
    {
        double cast;
        double escaped;
        double behind;
        double around = 0.0; ///< [1] the lost share of the rays of other patches around
        double lost() const { return escaped + behind; }
    };

    /// Keeps a reference to the counts, which must be merged. `area` [m^2] is per patch, and so is `density`
    /// [rays/m^2], the number of rays that left the patch over its area. `losses`, per patch, may leave out rays that
    /// decided how many others the patch cast: with them the losses would be biased. `side` numbers, per patch, the
    /// side of a surface that it is on. The patches `sky`, whose emission
    /// is uniform, are those of the sky; no ray may start or count as ending there. `unseen_rays` is a pseudo-count: so
    /// many rays per patch, besides the counted ones, are taken to have reached unknown patches. A positive number lets
    /// light get from every patch to every other, however few rays there are, at the price of a bias.
    SparseExchange(const LineCounts& counts, const std::vector<double>& area, const std::vector<double>& density,
                   std::vector<LossCounts> losses, const std::vector<std::uint32_t>& side,
                   std::vector<std::uint32_t> sky, double unseen_rays, int threads);

    std::uint32_t size() const override { return counts_.size(); }
    void multiply(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const override;
    double self_exchange(std::uint32_t patch) const override;
    double escaping(std::uint32_t patch) const override { return sky_.empty() ? open(patch) : 0.0; }
    double behind(std::uint32_t patch) const override { return std::max(0.0, lost_[patch] - open(patch)); }
    double row_area(std::uint32_t patch) const override { return area_[patch]; }

    /// [1] Fraction of the total area that step 2 adds: exchange that no ray has sampled.
    double unseen_share() const;
    /// [m^2] Total exchange area with the sky or the outside of the scene, and with sides without a patch.
    double lost_area() const;

    /// Light that leaves a patch along the ray that brought it. The solution of the linear system lets every ray of a
    /// patch bring light and take it away, so that the noise of what comes and of where it goes is correlated: with n
    /// rays, 1/n of the light returns where it came from. In an open scene too much of it thus escapes again. Without
    /// the ray r itself (leave-one-out), patch j sends along r
    ///
    ///   B_j + rho_j (H_j - L_r) / (n_j - 1),
    ///
    /// with the irradiance H_j that all n_j rays bring, and the radiosity L_r at the other end of r. The second term
    /// sums to zero over the rays of each patch.
    struct Returns
    {
        std::vector<Rgb> incident; ///< [W] per patch: sum of the second term over the rays that reach the patch
        Rgb escaped;               ///< [W] the same for the rays that reached nothing, without a sky
        Rgb behind;                ///< [W] and for those that met a side without a patch
    };
    Returns returns(const std::vector<Rgb>& radiosity, const std::vector<Rgb>& reflectance, int threads) const;

private:
    /// Single precision suffices and halves the memory to be read: the exchange stays exactly symmetric, and step 2
    /// makes its rows add up to the areas.
    struct Factors
    {
        float density; ///< d [rays per unit_]
        float scale;   ///< x [1]
    };

    bool is_sky(std::uint32_t patch) const { return std::find(sky_.begin(), sky_.end(), patch) != sky_.end(); }
    double part_lost(std::uint32_t i, double unseen_rays) const;
    double own_share(std::uint32_t i) const;
    std::vector<float> largest_scales(double most, int threads) const;
    double open(std::uint32_t patch) const;
    double joined(std::uint32_t i) const;
    Rgb light_of_sky(const std::vector<Rgb>& x) const;
    void find_spaces(const std::vector<std::uint32_t>& side);
    void bound_losses_around(const std::vector<std::uint32_t>& group);
    void move_cut_losses(const std::vector<std::uint32_t>& side, const std::vector<double>& cut);
    void share_deficits();
    std::vector<Rgb> spread_light(const std::vector<Rgb>& x) const;
    void give_to_sky(Rgb light, std::vector<Rgb>& y) const;
    void multiply_rays(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const;
    void balance(const std::vector<double>& wanted, const std::vector<double>& most, int threads);

    const LineCounts& counts_;
    std::vector<double> area_;
    double unit_ = 0.0; ///< [m^2] total area, the unit of areas that keeps numbers within the range of floats
    std::vector<Factors> factors_;
    std::vector<LossCounts> losses_;
    std::vector<std::uint32_t> sky_;
    double sky_area_ = 0.0;            ///< [m^2]
    std::vector<double> lost_;         ///< [m^2] exchange area with no patch
    double escaping_share_ = 1.0;      ///< [1] part of all lost rays that escaped
    std::vector<double> own_;          ///< [m^2] self-exchange: the deficit that is only rounding; of the sky
    std::vector<double> unseen_;       ///< [m^2] the part of the other deficits that is spread over the patches
    std::vector<std::uint32_t> space_; ///< per patch: the first patch of its space; empty if none is needed
    std::vector<bool> loses_;          ///< of each space, at its first patch: true if rays are lost
    std::vector<double> unseen_sum_;   ///< [m^2] of unseen_, at the first patch of each space
};

} // namespace multipath
