#pragma once

#include "commands/options/picture_options.h"
#include "radiosity/family/importance.h"
#include "scene/scene.h"

#include <memory>
#include <string>

namespace multipath {

/// What --important says: the patches of an object or a material of this name, all with the weight 1; or for "view"
/// those that the user's cameras see, in proportion to their share of the pictures. Throws UsageError for a view
/// without a camera of the user's, and InputError for a name that the scene does not have or whose patches reflect
/// nothing.
std::shared_ptr<const Importance> important_patches(const Scene& scene, const std::string& what,
                                                    const PictureOptions& pictures);

} // namespace multipath
