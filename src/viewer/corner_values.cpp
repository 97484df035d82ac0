#include "viewer/corner_values.h"

#include "image/corner_lattice.h"
#include "image/smooth_shading.h"

namespace multipath {

std::vector<Rgb> corner_values(const Scene& scene, const std::vector<Rgb>& values_per_patch)
{
    const SmoothShading shading(scene, values_per_patch);
    std::vector<Rgb> corners;
    for (const bool front : {true, false}) {
        if (!front && !scene.two_sided())
            break;
        for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface) {
            const CornerLattice lattice(scene.tessellation(surface));
            for (std::uint32_t j = 0; j <= lattice.last_row(); ++j)
                for (std::uint32_t i = 0; i <= lattice.last_column(j); ++i)
                    corners.push_back(shading.at({0.0, surface, lattice.u(i), lattice.v(j), front}));
        }
    }
    return corners;
}

} // namespace multipath
