// Any bytes as a table of patches: lists of one length, or an InputError.

#include "base/errors.h"
#include "export/patch_table.h"
#include "fuzz_file.h"

#include <cstdlib>

using namespace multipath;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const FuzzFolder folder;
    try {
        const PatchTable table = read_patch_table(folder.write("table.csv", fuzz_text(data, size)));
        const std::size_t patches = table.areas.size();
        const bool errors_fit = table.standard_error.empty() || table.standard_error.size() == patches;
        if (patches == 0 || table.radiosity.size() != patches || !errors_fit)
            std::abort();
    } catch (const InputError&) {
    }
    return 0;
}
