#pragma once

#include "cli/unfinished.h"

#include <string>

namespace multipath {

/// A new folder of the user's own under $TMPDIR, or /tmp; the destructor removes it with all it holds, a signal
/// that ends the program at once with the part files that it holds.
class TemporaryFolder
{
public:
    /// Throws OutputError.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
    Unfinished unfinished_;
};

} // namespace multipath
