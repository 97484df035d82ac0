#include "cli/temporary_folder.h"

#include "cli/output_file.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace multipath {

TemporaryFolder::TemporaryFolder()
{
    const char* const parent = std::getenv("TMPDIR");
    const std::string folder = parent != nullptr && *parent != '\0' ? parent : "/tmp";
    path_ = folder + "/multipath-XXXXXX";
    if (mkdtemp(path_.data()) == nullptr)
        throw OutputError("cannot make a folder in " + folder + ": " + std::generic_category().message(errno));
    unfinished_ = Unfinished(path_);
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

} // namespace multipath
