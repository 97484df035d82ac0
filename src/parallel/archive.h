#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace multipath {

/// A saved state is damaged or belongs to other work. The message is one line.
class ArchiveError : public std::runtime_error
{
public:
    explicit ArchiveError(const std::string& message) : std::runtime_error(message) {}
};

/// Element type of an array in an archive.
enum class Scalar : std::uint8_t { bytes = 1, u32 = 4, u64 = 8, f32 = 36, f64 = 40 };

/// Size of one element in bytes.
inline std::size_t size_of(Scalar scalar)
{
    return static_cast<std::size_t>(scalar) & 15u;
}

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
    else
        return Scalar::bytes;
}

/// A field of a record, with the name of the array that stores this field of many records.
template <class Number, class Record, class Value>
struct RecordField
{
    std::string_view name;
    Value Record::*member;
};

template <class Number, class Record, class Value>
RecordField<Number, Record, Value> field(std::string_view name, Value Record::*member)
{
    return {name, member};
}

/// Serialisation of named arrays. The same statements write and read them, so that both sides always agree. A value
/// that consists of several numbers is stored as these numbers.
class Archive
{
public:
    explicit Archive(bool reads) : reads_(reads) {}
    virtual ~Archive() = default;
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    bool reads() const { return reads_; }

    /// Writes or reads one value. Reading throws ArchiveError if the array is missing or of another type or length.
    template <class Number, class Value>
    void value(std::string_view name, Value& value)
    {
        transfer<Number>(name, &value, 1);
    }

    /// A list that must have its length before it is read; ArchiveError if the archive has another length.
    template <class Number, class List>
    void list(std::string_view name, List& values)
    {
        transfer<Number>(name, values.data(), values.size());
    }

    /// A list that is resized to the length in the archive when it is read.
    template <class Number, class List>
    void growing_list(std::string_view name, List& values)
    {
        constexpr std::size_t numbers = sizeof(typename List::value_type) / sizeof(Number);
        if (reads_)
            values.resize(length(full_name(name), scalar_of<Number>()) / numbers);
        list<Number>(name, values);
    }

    /// Like growing_list, but an empty list is not written and a missing one is read as empty.
    template <class Number, class List>
    void optional_list(std::string_view name, List& values)
    {
        if (reads_ ? holds(full_name(name)) : !values.empty())
            growing_list<Number>(name, values);
        else
            values.clear();
    }

    /// Any number of texts without zero bytes, stored as one list of bytes with a zero after each text.
    void texts(std::string_view name, std::vector<std::string>& texts)
    {
        std::string joined;
        for (const std::string& text : texts)
            joined.append(text).push_back('\0');
        growing_list<char>(name, joined);
        texts.clear();
        for (std::size_t begin = 0; begin < joined.size();) {
            const std::size_t end = std::min(joined.find('\0', begin), joined.size());
            texts.push_back(joined.substr(begin, end - begin));
            begin = end + 1;
        }
    }

    /// Any number of records, stored as one list per field (texts() for strings). Reading throws ArchiveError if the
    /// lists differ in length.
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

protected:
    virtual void write(const std::string& name, Scalar scalar, const void* data, std::size_t length) = 0;
    virtual void read(const std::string& name, Scalar scalar, void* data, std::size_t length) = 0;
    /// Reading: true if the archive contains the array.
    virtual bool holds(const std::string& name) const = 0;
    /// Reading: number of elements of an array.
    virtual std::size_t length(const std::string& name, Scalar scalar) = 0;

private:
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
        std::vector<Value> values;
        for (const Record& record : records)
            values.push_back(record.*field.member);
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
