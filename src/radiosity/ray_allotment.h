#pragma once

#include "radiosity/shadow_rays.h"

#include <vector>

namespace multipath {

/// Shadow rays per pair, on the average, when nothing is known of what stands between: adds up to `rays`. Each pair
/// gets one at least, or an equal part of half the rays if these are too few.
std::vector<double> first_allotment(const Scene& scene, const GatherPairs& pairs, double rays);

/// Shadow rays per pair in addition, on the average, after those of the first allotment have found `sights`: more where
/// a patch sees a light in part, or where the patches around it do, or some of them and some not. What a pair itself
/// has found has a say only if it has many rays, so that the sum of both looks has no bias worth mentioning.
std::vector<double> second_allotment(const Scene& scene, const GatherPairs& pairs, const std::vector<double>& first,
                                     const std::vector<Sight>& sights, double rays, int threads);

} // namespace multipath
