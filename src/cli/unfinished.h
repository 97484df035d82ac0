#pragma once

#include <string>

namespace multipath {

/// A part file, or a folder for such, that must not outlive a program which a signal ends: its destructors do not run
/// then. As long as one lives, remove_unfinished() removes what has this name. Of more than 64 at a time the others
/// stay, for the next run to remove.
class Unfinished
{
public:
    Unfinished() = default; ///< of nothing
    explicit Unfinished(const std::string& path);
    ~Unfinished() { forget(); }
    Unfinished(Unfinished&& other) noexcept;
    Unfinished& operator=(Unfinished&& other) noexcept;

private:
    void forget() noexcept;

    static constexpr int none = -1;

    int slot_ = none;
};

/// Removes all of them: files, and folders that are empty then. A handler of signals may call it.
void remove_unfinished() noexcept;

} // namespace multipath
