#pragma once

namespace multipath {

// Logical AND and OR of several conditions, all of which are evaluated. They avoid the branches of && and ||: these
// branches cost time where the outcome is hard to predict, and they prevent loops from being vectorised. A condition is
// a bool, or an integer 0 or 1.

/// True if all conditions hold.
template <class... Conditions>
constexpr bool every(Conditions... conditions)
{
    return (static_cast<unsigned>(conditions) & ...) != 0;
}

/// True if at least one condition holds.
template <class... Conditions>
constexpr bool any(Conditions... conditions)
{
    return (static_cast<unsigned>(conditions) | ...) != 0;
}

} // namespace multipath
