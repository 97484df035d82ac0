#pragma once

#include <cctype>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace multipath {

/// What a JSON text says. Texts keep their escapes.
struct JsonValue
{
    std::string text; ///< of a text without its quotes, and of a number, true, false or null
    std::vector<JsonValue> list;
    std::map<std::string, JsonValue> members;

    const JsonValue& operator[](const std::string& key) const { return members.at(key); }
    const JsonValue& operator[](std::size_t n) const { return list.at(n); }
    double number() const { return std::stod(text); }
    std::size_t count() const { return std::stoul(text); }
};

/// Reads strictly what RFC 8259 allows, but for the grammar of numbers and words. Throws.
class JsonReader
{
public:
    explicit JsonReader(const std::string& text) : text_(text) {}

    JsonValue document()
    {
        JsonValue value = this->value();
        if (next() != '\0')
            throw std::runtime_error("more than one value");
        return value;
    }

private:
    char next()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    void expect(char c)
    {
        if (next() != c)
            throw std::runtime_error(std::string("expected ") + c + " at " + std::to_string(at_));
        ++at_;
    }
    std::string quoted()
    {
        expect('"');
        std::string result;
        for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
            result += text_[at_];
            if (text_[at_] == '\\')
                result += text_[++at_];
        }
        expect('"');
        return result;
    }
    JsonValue value()
    {
        JsonValue result;
        if (next() == '"') {
            result.text = quoted();
        } else if (next() == '[') {
            for (char before = '['; next() == before; before = ',') {
                ++at_;
                if (next() != ']')
                    result.list.push_back(value());
            }
            expect(']');
        } else if (next() == '{') {
            for (char before = '{'; next() == before; before = ',') {
                ++at_;
                if (next() == '}')
                    break;
                const std::string key = quoted();
                expect(':');
                result.members[key] = value();
            }
            expect('}');
        } else {
            while (std::isalnum(static_cast<unsigned char>(next())) != 0 || next() == '-' || next() == '+' ||
                   next() == '.')
                result.text += text_[at_++];
            if (result.text.empty())
                throw std::runtime_error("no value at " + std::to_string(at_));
        }
        return result;
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

} // namespace multipath
