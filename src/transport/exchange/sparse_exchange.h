#pragma once

#include "base/memory.h"
#include "transport/exchange/exchange.h"
#include "transport/exchange/line_counts.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace multipath {

/// Exchange areas (exchange.h) estimated from counts of rays ((R4) in docs/equations.md), closed so that light is
/// conserved: symmetric, nowhere negative but for rounding, and with row sums equal to the areas of the patches. A row
/// sum here includes the losses (escaping and behind). d_i rays per m^2 leave patch i; C_ij rays join i and j, started
/// at either end, and L_i rays of i met no patch. They are Poisson numbers of means (d_i + d_j) G_ij and d_i G_i0.
///
/// Step 1 finds the exchange of greatest likelihood for which the rows add up to the areas (Aitchison and Silvey 1958):
/// G_ij = C_ij / (D_i + D_j) and G_i0 = L_i / D_i, with one density D = d - lambda per patch, lambda the multiplier of
/// its row. With D = d it would be the balance heuristic of Veach and Guibas (1995). What many rays of one end say is
/// hardly changed by the noise of the few of the other, and the losses are unbiased to first order in 1 / rays. After
/// the step no row sum exceeds the area of the patch.
///
/// Step 2: The deficit delta_i, the area of patch i minus its row sum, is exchange that no ray has sampled. In a space
/// that loses no ray it becomes self-exchange: spread over the patches, it would carry light past the few rays that
/// lead into a narrow gap. A space is the patches that rays join, directly or through others. In a space that loses
/// rays, the part that the rays of the same side of the surface have lost is lost, and the rest is shared: G_ij grows
/// by delta_i delta_j / sum of delta. So nothing gets into a space that no ray has entered. With tens of rays per patch
/// this is a small part of the whole. A deficit from rounding alone becomes self-exchange everywhere.
///
/// If the scene has a sky, all that escapes reaches it. Its patches cast no rays: what they exchange with the other
/// patches is known from these, and the rest of their area is exchange with themselves. So the irradiance from a sky is
/// exact if all rays of a patch reach it.
class SparseExchange : public Exchange
{
public:
    /// Keeps references to `cast` and to the counts, which must be merged. `area` [m^2] is per patch, and so is `cast`,
    /// the number of rays that left the patch. `side` numbers, per patch, the side of a surface that it is on. The
    /// patches `sky`, whose emission is uniform, are those of the sky; no ray may start or count as ending there.
    /// `unseen_rays` is a pseudo-count: so many rays per patch, besides the counted ones, are taken to have reached
    /// unknown patches. A positive number lets light get from every patch to every other, however few rays there are,
    /// at the price of a bias.
    SparseExchange(const LineCounts& counts, const std::vector<double>& area, const std::vector<double>& cast,
                   const std::vector<std::uint32_t>& side, std::vector<std::uint32_t> sky, double unseen_rays,
                   int threads);

    std::uint32_t size() const override { return counts_.size(); }
    std::vector<Rgb> apply(const std::vector<Rgb>& x, int threads) const override;
    double self_exchange(std::uint32_t patch) const override;
    double escaping(std::uint32_t patch) const override { return sky_.empty() ? open_[patch] : 0.0; }
    double behind(std::uint32_t patch) const override { return std::max(0.0, lost_[patch] - open_[patch]); }
    double row_area(std::uint32_t patch) const override { return area_[patch]; }

    /// [m^2] Total exchange area with the sky or the outside of the scene, and with sides without a patch.
    double lost_area() const;

    /// Light that leaves a patch along the ray that brought it. The solution of the linear system lets every ray of a
    /// patch bring light and take it away, so that the noise of what comes and of where it goes is correlated: with n
    /// rays, 1/n of the light returns where it came from. In an open scene too much of it thus escapes again. With the
    /// exchange areas G_q of the rays of patch j, their sum A (fixed) and the sum of squares S, the product G_q G_r of
    /// two different rays is on the mean too small by the fraction (G_q + G_r) / A - S / A^2: each of the two takes
    /// from the other, and the fluctuation of the sum of all other rays makes up for a part of it. Over all q this adds
    /// up to G_r^2, what ray r should not send back. So patch j sends along r also
    ///
    ///   rho_j / A G_r ((sum of G_q^2 L_q - S H) / A + G_r (H - L_r)),
    ///
    /// with the radiosity L_q at the other end of ray q, and the irradiance H, the mean of L weighted by G: for n equal
    /// rays G_r rho (H - L_r) / n, with n - 1 instead of n if they are few. This sums to zero over the rays of each
    /// patch, and is zero where they all bring the same light. For n > 16 it is multiplied by the root of 16 / n.
    struct Returns
    {
        std::vector<Rgb> incident; ///< [W] per patch: sum over the rays that reach the patch
        Rgb escaped;               ///< [W] the same for the rays that reached nothing, without a sky
        Rgb behind;                ///< [W] and for those that met a side without a patch
    };
    Returns returns(const std::vector<Rgb>& radiosity, const std::vector<Rgb>& reflectance, int threads) const;

private:
    /// Single precision suffices and halves the memory to be read: the exchange stays exactly symmetric, and step 2
    /// makes its rows add up to the areas.
    struct Factors
    {
        float density; ///< D [rays per unit_]
        float scale;   ///< [1] below 1 where the rays would have more than the area of the patch
    };

    /// What the rays that left a side of a surface say of its losses.
    struct SideLosses
    {
        double area = 0.0; ///< [m^2] of its patches that cast rays
        double lost = 0.0; ///< [m^2] the area of each patch times the fraction of its rays that met no patch
        double rays = 0.0; ///< number of these
        double share() const { return quotient(lost, area); } ///< [1]
    };

    bool is_sky(std::uint32_t patch) const { return std::find(sky_.begin(), sky_.end(), patch) != sky_.end(); }
    bool loses(std::uint32_t patch) const { return !space_.empty() && loses_[space_[patch]]; }
    double density(std::uint32_t patch) const { return static_cast<double>(factors_[patch].density); }
    double scale(std::uint32_t patch) const { return static_cast<double>(factors_[patch].scale); }
    /// Rays of the patch that met no patch.
    double rays_lost(std::uint32_t patch) const
    {
        return static_cast<double>(counts_.escaped(patch)) + static_cast<double>(counts_.behind(patch));
    }
    double joined(std::uint32_t i) const;
    double lost(std::uint32_t i) const;
    Rgb light_of_sky(const std::vector<Rgb>& x) const;
    void find_spaces(const std::vector<std::uint32_t>& side);
    std::vector<SideLosses> losses_of_sides(const std::vector<std::uint32_t>& side) const;
    void correct_losses(const std::vector<std::uint32_t>& side, const std::vector<SideLosses>& of_sides);
    void give_to_sky(Rgb light, std::vector<Rgb>& y) const;
    std::vector<Rgb> apply_rays(const std::vector<Rgb>& x, int threads) const;
    void balance(const std::vector<double>& wanted, int threads);

    const LineCounts& counts_;
    std::vector<double> area_;
    const std::vector<double>& cast_;
    std::vector<std::uint32_t> sky_;
    double unit_ = 0.0; ///< [m^2] total area, the unit of areas that keeps numbers within the range of floats
    std::vector<Factors> factors_ = vector_with_capacity<Factors>(area_.size());
    double sky_area_ = 0.0; ///< [m^2]
    /// Rays of a patch that met no patch, as if all its rays had counted for that.
    std::vector<double> lost_rays_ = large_vector<double>(area_.size());
    std::vector<double> lost_ = large_vector<double>(area_.size()); ///< [m^2] exchange area with no patch
    std::vector<double> open_ = lost_; ///< [m^2] the part of it with the sky or the outside of the scene
    std::vector<double> own_ = lost_;  ///< [m^2] self-exchange: deficits from rounding and of closed spaces; of the sky
    std::vector<double> unseen_ = lost_; ///< [m^2] the part of the other deficits that is spread over the patches
    std::vector<std::uint32_t> space_;   ///< per patch: the first patch of its space; empty if no ray is lost
    std::vector<bool> loses_;            ///< of each space, at its first patch: true if rays are lost
    std::vector<double> unseen_sum_;     ///< [m^2] of unseen_, at the first patch of each space
};

} // namespace multipath
