#pragma once

#include "scene/scene_file.h"

namespace multipath {

/// Puts the scene into a box of six black rectangles whose fronts look inward and emit [W/m^2]: light of the same
/// radiance, emittance / pi, from all directions outside. A surface that sees nothing but this sky receives
/// `emittance`. The rectangles are the last surfaces of the file.
void add_sky(SceneFile& file, Rgb emittance);

/// The sun at an azimuth, clockwise from north, and an elevation above the horizon [degrees]. North is -z where y is
/// up, as in exported files, and +y where z is up; east is +x. `irradiance` [W/m^2] of a plane that faces it.
Sun sun_at(double azimuth, double elevation, Vec3 up, Rgb irradiance);

} // namespace multipath
