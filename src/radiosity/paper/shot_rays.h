#pragma once

#include "parallel/blocks.h"
#include "radiosity/paper/shots.h"
#include "transport/lines/local_rays.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Number of rays of one shot that arrived at each receiver. Counting first and multiplying by the power later avoids
/// the drift of adding the same number 10^8 times.
class ReceivedRays
{
public:
    explicit ReceivedRays(const Scene& scene) : scene_(scene), counts_(scene.patch_count(), 0) {}

    /// Counts the rays first ... end - 1 of these. `state`, into which they will be deposited, is prefetched.
    void add(const std::vector<std::uint32_t>& receivers, std::size_t first, std::size_t end, const PowerState& state);
    /// Adds the power of the counted rays, all from `shot`, to the state (S1), and resets the counts.
    void deposit(const Shot& shot, PowerState& state);
    void visit(Archive& archive); ///< for a checkpoint

private:
    void fetch(std::uint32_t receiver, const PowerState& state) const;
    void add(std::uint32_t receiver);

    const Scene& scene_;
    std::vector<std::uint64_t> counts_;  ///< per patch
    std::vector<std::uint32_t> touched_; ///< patches with a count above zero
    std::uint64_t behind_ = 0;
    std::uint64_t outside_ = 0;
};

/// The rays of all shots, in order: a stage (parallel/stage.h), whose results are in `state`.
class ShotRays
{
public:
    using Block = RayBlock;

    /// Keeps references to the arguments.
    ShotRays(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const std::vector<Shot>& shots,
             PowerState& state);

    Blocks lines() const;
    void trace(std::uint64_t number, RayBlock& block) const;
    std::uint64_t take(std::uint64_t number, const RayBlock& block);
    void finish(); ///< deposits the rays of the last shot
    void visit(Archive& archive);

private:
    std::size_t shot_of_ray(std::uint64_t ray) const;

    const Scene& scene_;
    const Sequence& sequence_;
    const std::uint64_t first_item_;
    const std::vector<Shot>& shots_;
    const std::vector<std::uint64_t> before_; ///< number of rays before each shot, and the total as the last entry
    PowerState& state_;
    ReceivedRays received_;
    std::uint64_t shot_ = 0; ///< the one whose rays are being counted
};

} // namespace multipath
