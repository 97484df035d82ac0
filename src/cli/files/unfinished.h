#pragma once

#include <string>

namespace multipath {

/// A part file that must not outlive a program which a signal ends: its destructors do not run then. As long as one
/// lives, remove_unfinished() removes the file. Of more than 64 at a time the others
/// stay, for the next run to remove.
class Unfinished
{
public:
    Unfinished() = default; ///< of nothing
    /// `target`: the file that it will become.
    Unfinished(const std::string& path, const std::string& target);
    ~Unfinished() { forget(); }
    Unfinished(Unfinished&& other) noexcept;
    Unfinished& operator=(Unfinished&& other) noexcept;

    /// Nothing is missing but the target's name.
    void complete() noexcept;

private:
    void forget() noexcept;

    static constexpr int none = -1;

    int slot_ = none;
};

/// Removes all of them. A handler of signals may call it.
void remove_unfinished() noexcept;

/// The same, but what is complete gets the name of its target. `not_written` is called with the target of each of the
/// others.
void settle_unfinished(void (*not_written)(const char* target)) noexcept;

} // namespace multipath
