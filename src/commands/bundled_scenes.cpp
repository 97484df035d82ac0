#include "commands/bundled_scenes.h"

#include <filesystem>
#include <system_error>

namespace multipath {

namespace {

namespace fs = std::filesystem;

} // namespace

std::string bundled_scenes_folder()
{
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error); // of systems without it: empty
    if (error || !program.has_parent_path())
        return "";
    const fs::path folder = program.parent_path();
    for (const fs::path& scenes : {folder.parent_path() / "share" / "multipath" / "scenes", folder / "scenes"})
        if (fs::is_directory(scenes, error))
            return scenes.string();
    return "";
}

std::string find_scene(const std::string& name)
{
    std::error_code error;
    if (name.empty() || name.find('/') != std::string::npos || fs::exists(name, error))
        return name;
    const std::string folder = bundled_scenes_folder();
    if (!folder.empty())
        for (const std::string& file : {folder + "/" + name, folder + "/" + name + ".obj"})
            if (fs::is_regular_file(file, error) && fs::path(file).extension() == ".obj")
                return file;
    return name;
}

} // namespace multipath
