// Any bytes as an image: pixels of the size told, or an ImageError.

#include "base/errors.h"
#include "fuzz_file.h"
#include "scene/texture/image_formats.h"

#include <cstdlib>

using namespace multipath;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    for (const char* const name : {"x.png", "x.tga"})
        try {
            const Bitmap image = read_image(name, fuzz_text(data, size));
            if (image.rgb.empty() || image.rgb.size() != std::size_t{3} * image.width * image.height)
                std::abort();
        } catch (const ImageError&) {
        }
    return 0;
}
