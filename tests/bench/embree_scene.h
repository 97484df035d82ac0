#pragma once

#include "geometry/line.h"
#include "geometry/surface.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace multipath {

/// The same work done by Intel's Embree, where it was found when the benchmark was built: single precision, triangles,
/// one thread, built for the fastest queries.
class EmbreeScene
{
public:
    static bool available();
    static std::string version(); ///< "Embree 3"

    /// `triangles` must all be triangles.
    explicit EmbreeScene(const SurfaceList& triangles);
    ~EmbreeScene();

    /// All hits of each line by a filter function that counts and refuses them; returns how many.
    double count_all_hits(const std::vector<Line>& lines) const;

    /// How many of the rays hit anything.
    double count_closest_hits(const std::vector<Line>& rays) const;

    /// How many of the rays hit anything before the parameter 1, where their targets are.
    double count_occluded(const std::vector<Line>& rays) const;

private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
};

} // namespace multipath
