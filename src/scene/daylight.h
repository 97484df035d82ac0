#pragma once

#include "scene/scene_file.h"

namespace multipath {

/// Encloses the scene in a box of six black rectangles that face inward and emit `emittance` [W/m^2]: a sky of uniform
/// radiance emittance / pi. A surface that sees only this sky has the irradiance `emittance`. The box is the bounding
/// box of the scene, enlarged on each side by 5 % of its diagonal. The rectangles become the last surfaces of the file,
/// with a material and a group of their own.
void add_sky(SceneFile& file, Rgb emittance);

/// The sun at an azimuth [degrees], clockwise from north, and an elevation [degrees] above the horizon. North is -z if
/// y is up, as in exported files, and +y if z is up; east is +x in both cases. For another `up`, north is the
/// projection of -z onto the horizontal plane, or that of +y if `up` is within about 26 degrees of the z axis.
/// `irradiance` [W/m^2] is that of a plane facing the sun.
Sun sun_at(double azimuth, double elevation, Vec3 up, Rgb irradiance);

} // namespace multipath
