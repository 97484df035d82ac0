#pragma once

#include "export/line_drawing.h"
#include "radiosity/global_story.h"
#include "radiosity/particle_story.h"
#include "radiosity/shot_story.h"

#include <vector>

namespace multipath {

// The told lines as they are drawn. What leaves the scene is drawn a little way.

std::vector<DrawnLine> drawn_lines(const GlobalStory& story);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const ShotStory& story);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const ParticleStory& story);

} // namespace multipath
