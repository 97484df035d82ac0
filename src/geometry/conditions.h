#pragma once

namespace multipath {

// Logical AND and OR of several conditions, all of which are evaluated. They avoid the branches of && and ||, which
// cost time where the outcome is hard to predict and prevent loops from being vectorised.

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
