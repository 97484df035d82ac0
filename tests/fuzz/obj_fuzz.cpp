// Any bytes as an OBJ file: a scene that keeps its promises, or an InputError.

#include "base/errors.h"
#include "fuzz_file.h"
#include "scene/obj/obj_reader.h"
#include "scene/scene.h"
#include "scene/tessellation.h"

#include <cmath>
#include <cstdlib>
#include <utility>

using namespace multipath;

namespace {

void require(bool promise)
{
    if (!promise)
        std::abort();
}

/// What the solver takes for granted.
void require_sound(const Scene& scene)
{
    require(std::isfinite(scene.total_area()) && scene.total_area() > 0.0);
    require(std::isfinite(mean(scene.source_power())));
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Rgb reflectance = scene.reflectance(i);
        require(scene.area(i) > 0.0);
        require(reflectance.r >= 0.0 && reflectance.r <= 1.0);
        require(reflectance.g >= 0.0 && reflectance.g <= 1.0);
        require(reflectance.b >= 0.0 && reflectance.b <= 1.0);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const FuzzFolder folder;
    static const std::string materials =
        folder.write("a.mtl", "newmtl lamp\nKd 0 0 0\nKe 5 5 5\nnewmtl wall\nKd 0.5 0.5 0.5\n");
    try {
        SceneFile file = read_obj(folder.write("scene.obj", fuzz_text(data, size)));
        const double patch_size = patch_size_for_count(file.surfaces, 100);
        require_sound(Scene(std::move(file), patch_size, true));
    } catch (const InputError&) {
    }
    return 0;
}
