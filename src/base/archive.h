#pragma once

#include "base/errors.h"
#include "base/lists.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace multipath {

/// Element type of an array in an archive. The low four bits are the size of an element in bytes.
enum class Scalar : std::uint8_t { bytes = 1, u32 = 4, u64 = 8, f32 = 36, f64 = 40 };

/// Size of one element in bytes.
inline std::size_t size_of(Scalar scalar)
{
    return static_cast<std::size_t>(scalar) & 15u;
}

/// Element type of an array of these numbers.
template <class Number>
constexpr Scalar scalar_of()
{
    if constexpr (std::is_same_v<Number, double>)
        return Scalar::f64;
    else if constexpr (std::is_same_v<Number, float>)
        return Scalar::f32;
    else if constexpr (std::is_same_v<Number, std::uint64_t>)
        return Scalar::u64;
    else if constexpr (std::is_same_v<Number, std::uint32_t>)
        return Scalar::u32;
    else {
        static_assert(sizeof(Number) == 1);
        return Scalar::bytes;
    }
}

/// A field of a record, for Archive::records: a member, and the name of the array that stores this member of all
/// records as values of type Number.
template <class Number, class Record, class Value>
struct RecordField
{
    std::string_view name;
    Value Record::*member;
};

/// Makes a RecordField; only Number must be given explicitly.
template <class Number, class Record, class Value>
RecordField<Number, Record, Value> field(std::string_view name, Value Record::*member)
{
    return {name, member};
}

/// Serialisation of named arrays. The same statements write and read the arrays, so that both sides always agree. A
/// value that consists of several numbers is stored as these numbers. All functions that read throw ArchiveError if the
/// array is missing, has another element type, or has another length than expected.
class Archive
{
public:
    explicit Archive(bool reads) : reads_(reads) {} ///< `reads`: true to read, false to write
    virtual ~Archive() = default;
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    bool reads() const { return reads_; }

    /// Writes or reads one value, as an array of one element.
    template <class Number, class Value>
    void value(std::string_view name, Value& value)
    {
        transfer<Number>(name, &value, 1);
    }

    /// Writes or reads a list. When it is read, the list must already have the length of the written list.
    template <class Number, class List>
    void list(std::string_view name, List& values)
    {
        transfer<Number>(name, values.data(), values.size());
    }

    /// Writes or reads a list of any length. When it is read, the list is resized to the length of the written list.
    template <class Number, class List>
    void growing_list(std::string_view name, List& values)
    {
        constexpr std::size_t numbers = sizeof(typename List::value_type) / sizeof(Number);
        if (reads_)
            values.resize(length(full_name(name), scalar_of<Number>()) / numbers);
        list<Number>(name, values);
    }

    /// Like growing_list, but an empty list is not written, and a missing array is read as an empty list.
    template <class Number, class List>
    void optional_list(std::string_view name, List& values)
    {
        if (reads_ ? holds(full_name(name)) : !values.empty())
            growing_list<Number>(name, values);
        else
            values.clear();
    }

    /// Writes or reads any number of texts without zero bytes, stored as one list of bytes with a zero after each text.
    /// `optional`: as an optional_list().
    void texts(std::string_view name, std::vector<std::string>& texts, bool optional = false)
    {
        std::string joined;
        for (const std::string& text : texts)
            joined.append(text).push_back('\0');
        optional ? optional_list<char>(name, joined) : growing_list<char>(name, joined);
        texts.clear();
        for (std::size_t begin = 0; begin < joined.size();) {
            const std::size_t end = std::min(joined.find('\0', begin), joined.size());
            texts.push_back(joined.substr(begin, end - begin));
            begin = end + 1;
        }
    }

    /// Writes or reads any number of records, stored as one list per field (texts() for strings). Reading resizes
    /// `records` to the length of the first list, and throws ArchiveError if another list has a different length.
    template <class Record, class First, class... Others>
    void records(std::vector<Record>& records, const First& first, const Others&... others)
    {
        visit_field(records, first, true);
        (visit_field(records, others, false), ...);
    }

    /// Scope in which all names get the prefix `part`/. Scopes can be nested.
    class Inner
    {
    public:
        Inner(Archive& archive, const std::string& part) : archive_(archive), length_(archive.prefix_.size())
        {
            archive_.prefix_ += part + "/";
        }
        ~Inner() { archive_.prefix_.resize(length_); }
        Inner(const Inner&) = delete;
        Inner& operator=(const Inner&) = delete;

    private:
        Archive& archive_;
        std::size_t length_;
    };

    /// Calls object.visit(archive) in a scope of this name.
    template <class Object>
    void object(const std::string& name, Object& object)
    {
        const Inner inner(*this, name);
        object.visit(*this);
    }

protected:
    /// Writes or reads an array of `length` elements. read() throws ArchiveError if the array is missing, or has
    /// another element type or length. An archive overrides write(), or the functions that read.
    virtual void write(const std::string&, Scalar, const void*, std::size_t) { throw misused(); }
    virtual void read(const std::string&, Scalar, void*, std::size_t) { throw misused(); }
    /// Only for reading: true if the archive contains the array.
    virtual bool holds(const std::string&) const { throw misused(); }
    /// Only for reading: number of elements of an array. Throws ArchiveError if the array is missing or has another
    /// element type.
    virtual std::size_t length(const std::string&, Scalar) { throw misused(); }

private:
    static std::logic_error misused() { return std::logic_error("an archive that only reads or only writes"); }
    std::string full_name(std::string_view name) const { return prefix_ + std::string(name); }

    template <class Number, class Value>
    void transfer(std::string_view name, Value* values, std::size_t count)
    {
        static_assert(std::is_trivially_copyable_v<Value> && sizeof(Value) % sizeof(Number) == 0,
                      "a value must consist of such numbers");
        const std::size_t numbers = count * (sizeof(Value) / sizeof(Number));
        if (reads_)
            read(full_name(name), scalar_of<Number>(), values, numbers);
        else
            write(full_name(name), scalar_of<Number>(), values, numbers);
    }

    template <class Number, class Record, class Value>
    void visit_field(std::vector<Record>& records, const RecordField<Number, Record, Value>& field, bool sets_length)
    {
        std::vector<Value> values = mapped(records, field.member);
        if constexpr (std::is_same_v<Value, std::string>)
            texts(field.name, values);
        else if (sets_length)
            growing_list<Number>(field.name, values);
        else
            list<Number>(field.name, values);
        if (sets_length)
            records.resize(values.size());
        if (records.size() != values.size())
            throw ArchiveError("the state is damaged: no such " + std::string(field.name));
        for (std::size_t k = 0; k < values.size(); ++k)
            records[k].*field.member = values[k];
    }

    bool reads_;
    std::string prefix_;
};

} // namespace multipath
