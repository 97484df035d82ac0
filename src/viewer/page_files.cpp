#include "viewer/page_files.h"

#include <stdexcept>
#include <string>

namespace multipath {

namespace {

struct PageFile
{
    std::string_view name;
    std::string_view text;
};

constexpr PageFile page_files[] = {
#include "viewer/page_files.inc"
};

} // namespace

std::string_view page_file(std::string_view name)
{
    for (const PageFile& file : page_files)
        if (file.name == name)
            return file.text;
    throw std::logic_error("the program holds no page file " + std::string(name));
}

} // namespace multipath
