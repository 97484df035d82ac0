// Any bytes as an MTL file: materials that reflect and emit what light can, or an InputError.

#include "base/errors.h"
#include "fuzz_file.h"
#include "scene/obj/mtl_reader.h"

#include <cmath>
#include <cstdlib>

using namespace multipath;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const FuzzFolder folder;
    const std::string path = folder.write("scene.mtl", fuzz_text(data, size));
    try {
        MaterialLibrary library;
        read_mtl(path, library);
        for (const MtlMaterial& entry : library.materials) {
            const Rgb emittance = entry.material.emittance;
            for (const double value : {emittance.r, emittance.g, emittance.b})
                if (!(std::isfinite(value) && value >= 0.0))
                    std::abort();
        }
    } catch (const InputError&) {
    }
    return 0;
}
