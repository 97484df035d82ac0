#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace multipath {

/// True if an element of the list equals the value.
template <class Value, class List>
bool is_among(const Value& value, const List& list)
{
    return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

/// The list of make(element) for the elements of a list, in order. `make` may be a pointer to a member.
template <class List, class Make>
auto mapped(const List& list, const Make& make)
{
    std::vector<std::decay_t<decltype(std::invoke(make, *std::begin(list)))>> result;
    result.reserve(static_cast<std::size_t>(std::distance(std::begin(list), std::end(list))));
    for (const auto& element : list)
        result.push_back(std::invoke(make, element));
    return result;
}

/// The list of make(i) for i = 0 ... count - 1, in order; parallel_list() is the same on several threads.
template <class Count, class Make>
auto serial_list(Count count, const Make& make)
{
    std::vector<std::decay_t<decltype(make(count))>> result;
    result.reserve(static_cast<std::size_t>(count));
    for (Count i = 0; i < count; ++i)
        result.push_back(make(i));
    return result;
}

/// Sum of term(element) over the elements of a list, added in order. `term` may be a pointer to a member.
template <class List, class Term>
auto sum_over(const List& list, const Term& term)
{
    std::decay_t<decltype(std::invoke(term, *std::begin(list)))> sum{};
    for (const auto& element : list)
        sum += std::invoke(term, element);
    return sum;
}

} // namespace multipath
