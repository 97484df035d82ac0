#pragma once

#include "parallel/archive.h"
#include "parallel/huge_pages.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace multipath {

/// Memory that the system hands out zeroed when it is first touched, so that a large table costs nothing to begin with.
/// For plain numbers, whose zero is all bits zero.
template <class Value>
struct ZeroedMemory
{
    static_assert(std::is_trivially_copyable<Value>::value, "all bits zero must be a value");
    using value_type = Value;

    ZeroedMemory() = default;
    template <class Other>
    explicit ZeroedMemory(const ZeroedMemory<Other>&)
    {
    }

    Value* allocate(std::size_t count)
    {
        void* const memory = std::calloc(count, sizeof(Value));
        if (memory == nullptr)
            throw std::bad_alloc();
        ask_for_huge_pages(memory, count * sizeof(Value));
        return static_cast<Value*>(memory);
    }
    void deallocate(Value* memory, std::size_t) { std::free(memory); }
    template <class Other>
    void construct(Other*)
    {
    }
    template <class Other, class... Arguments>
    void construct(Other* place, Arguments&&... arguments)
    {
        ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
    }
    bool operator==(const ZeroedMemory&) const { return true; }
    bool operator!=(const ZeroedMemory&) const { return false; }
};

/// One value for each unordered pair of n patches, a patch with itself included: the lower triangle, row by row.
template <class Value>
class PairMatrix
{
public:
    explicit PairMatrix(std::uint32_t n) : n_(n), values_(pair_count(n)) {}

    std::uint32_t size() const { return n_; }

    Value& at(std::uint32_t i, std::uint32_t j) { return values_[index(i, j)]; }
    const Value& at(std::uint32_t i, std::uint32_t j) const { return values_[index(i, j)]; }

    /// The pairs (i, 0), (i, 1) ... (i, i).
    Value* row(std::uint32_t i) { return values_.data() + pair_count(i); }
    const Value* row(std::uint32_t i) const { return values_.data() + pair_count(i); }

    /// For a checkpoint: the values, made of such numbers.
    template <class Number>
    void visit(Archive& archive, std::string_view name)
    {
        archive.list<Number>(name, values_);
    }

    static std::size_t pair_count(std::uint32_t n) { return std::size_t{n} * (std::size_t{n} + 1) / 2; }
    static std::size_t index(std::uint32_t i, std::uint32_t j) { return i < j ? pair_count(j) + i : pair_count(i) + j; }

private:
    std::uint32_t n_;
    std::vector<Value, ZeroedMemory<Value>> values_;
};

} // namespace multipath
