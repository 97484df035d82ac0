#pragma once

#include <string>

namespace multipath {

/// The folder of the scenes that come with the program: of an installed one PREFIX/share/multipath/scenes, of one that
/// was built beside its sources their folder `scenes`. Empty when there is none or the program cannot tell where it is.
std::string bundled_scenes_folder();

/// The path of a scene: the name itself if there is such a file, otherwise for a bare name, with or without `.obj`, the
/// bundled scene of that name. Without one the name itself, so that the reader's message has what was typed.
std::string find_scene(const std::string& name);

} // namespace multipath
