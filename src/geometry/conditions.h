#pragma once

namespace multipath {

// Several conditions at once, all of them evaluated: without the branches of && and ||, where their outcome is hard to
// predict or a loop is to be vectorised.

template <class... Conditions>
constexpr bool every(Conditions... conditions)
{
    return (static_cast<unsigned>(conditions) & ...) != 0;
}

template <class... Conditions>
constexpr bool any(Conditions... conditions)
{
    return (static_cast<unsigned>(conditions) | ...) != 0;
}

} // namespace multipath
