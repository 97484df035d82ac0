#pragma once

#include "image/gather/gather_point.h"
#include "image/gather/source_light.h"
#include "image/shading/smooth_shading.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// Irradiance of a point by indirect light.
struct IndirectSample
{
    GatherPoint receiver;
    Rgb irradiance; ///< [W/m^2]
    /// [scene units] harmonic mean of the distances at which the rays meet surfaces. A ray that meets none counts as
    /// infinitely long, but the mean stays finite. 0: no sample.
    double distance = 0.0;
};

/// Indirect light, which was reflected at least once before it arrives. It is gathered with cosine-distributed rays
/// over the hemisphere. A ray looks up the reflected part of the solution, interpolated by SmoothShading, at the point
/// where the ray ends. Immutable and safe to share between threads.
class IndirectLight
{
public:
    /// `radiosity`: the solution [W/m^2] per patch. `rays`: number of rays per point; 0 means no indirect light. The
    /// scene and `near` must outlive this object.
    ///
    /// Where a ray is shorter than the patch at its end is wide, the interpolated value may be too coarse. If `near`,
    /// the direct light of the scene, is given, light is gathered anew at the ends of such rays: from the sources, and
    /// along one further ray (as by H. W. Jensen: Global illumination using photon maps, 1996). This removes the error
    /// where surfaces touch, but adds noise, so pictures do without.
    IndirectLight(const Scene& scene, const std::vector<Rgb>& radiosity, int rays, int threads,
                  const SourceLight* near = nullptr);

    /// Gathers at the point `receiver`. The rays use the items of `sequence` (an item is one of its points, sequence.h)
    /// from index number * rays to (number + 1) * rays - 1, so that the rays of receivers with consecutive numbers are
    /// stratified together. `fan`: reusable buffers of one thread.
    IndirectSample at(const GatherPoint& receiver, const Sequence& sequence, std::uint64_t number, RayFan& fan) const;

    /// [W/m^2] Irradiance of a point by the sources, too, with as many rays to them. `bits`: random, of this point. Its
    /// sequences are its own, since the items of one sequence are not independent.
    Rgb irradiance(const GatherPoint& receiver, const SourceLight& sources, std::uint64_t bits) const;

private:
    bool is_near(const Hit& hit) const;
    Rgb reflected_at(Hit hit, const Sequence& sequence, const Item& item, std::uint64_t bits, RayFan& fan) const;

    const Scene& scene_;
    const SourceLight* near_; ///< null: all light is looked up
    std::size_t rays_;
    SmoothShading reflected_light_;
};

/// Irradiance cache in image space: samples of indirect light at the points seen through pixel centres, interpolated at
/// nearby points. Indirect light varies slowly except near other surfaces (G. Ward, F. Rubinstein, R. Clear: A ray
/// tracing solution for diffuse interreflection, SIGGRAPH 1988).
class IndirectGrid
{
public:
    /// A grid of width x height pixels without samples.
    IndirectGrid(int width, int height);

    /// Stores the sample of pixel (x, y). Threads may set different pixels at the same time.
    void set(int x, int y, const IndirectSample& sample);

    /// [W/m^2] Irradiance of a point seen through pixel (x, y), interpolated from the samples of the pixels around it.
    /// Nothing if the estimated error of every sample at the point is too large.
    std::optional<Rgb> irradiance(const GatherPoint& receiver, int x, int y) const;

    /// True if the samples of pixels with even coordinates alone suffice for a point seen through pixel (x, y). Reads
    /// no other samples, so that threads may set those at the same time.
    bool is_supported(const GatherPoint& receiver, int x, int y) const;

private:
    /// A weighted sum of the samples around a pixel.
    struct Shared
    {
        Rgb irradiance;       ///< [W/m^2] sum of weight * irradiance
        double weights = 0.0; ///< sum of the weights
        int pixels = 0;       ///< number of pixels visited, with or without a sample

        bool is_enough() const; ///< true if the mean weight is high
    };

    Shared shared(const GatherPoint& receiver, int x, int y, int reach, int spacing) const;

    int width_;
    int height_;
    std::vector<IndirectSample> samples_; ///< per pixel; distance 0 means none
};

} // namespace multipath
