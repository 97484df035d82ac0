#include "cli/shell_words.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::string_view plain_characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,^%+=@";

bool is_control(char c)
{
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

bool is_octal(char c)
{
    return c >= '0' && c <= '7';
}

/// Inside $'...'
std::string escaped(char c)
{
    if (c == '\'' || c == '\\')
        return {'\\', c};
    if (!is_control(c))
        return {c};
    return {'\\', static_cast<char>('0' + (c >> 6)), static_cast<char>('0' + (c >> 3 & 7)),
            static_cast<char>('0' + (c & 7))};
}

/// Takes words off the front of a text.
class ShellReader
{
public:
    explicit ShellReader(std::string_view text) : rest_(text) {}

    std::optional<std::vector<std::string>> words()
    {
        std::vector<std::string> result;
        for (skip_blanks(); !rest_.empty(); skip_blanks()) {
            result.emplace_back();
            while (!rest_.empty() && rest_[0] != ' ')
                if (!read_piece(result.back()))
                    return std::nullopt;
        }
        return result;
    }

private:
    void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

    bool starts_with(std::string_view start) const { return rest_.substr(0, start.size()) == start; }

    /// False for what shell_word() does not write.
    bool read_piece(std::string& word)
    {
        if (starts_with("'"))
            return read_quoted(word);
        if (starts_with("$'"))
            return read_escaped(word);
        const bool quote = starts_with("\\'");
        if (!quote && plain_characters.find(rest_[0]) == std::string_view::npos)
            return false;
        word += rest_[quote ? 1 : 0];
        rest_.remove_prefix(quote ? 2 : 1);
        return true;
    }

    bool read_quoted(std::string& word)
    {
        const std::size_t end = rest_.find('\'', 1);
        if (end == std::string_view::npos)
            return false;
        word += rest_.substr(1, end - 1);
        rest_.remove_prefix(end + 1);
        return true;
    }

    bool read_escaped(std::string& word)
    {
        rest_.remove_prefix(2);
        while (!rest_.empty() && rest_[0] != '\'')
            if (rest_[0] != '\\')
                take_into(word);
            else if (!read_escape(word))
                return false;
        if (rest_.empty())
            return false;
        rest_.remove_prefix(1);
        return true;
    }

    bool read_escape(std::string& word)
    {
        rest_.remove_prefix(1);
        if (starts_with("'") || starts_with("\\")) {
            take_into(word);
            return true;
        }
        if (rest_.size() < 3 || !std::all_of(rest_.begin(), rest_.begin() + 3, is_octal))
            return false;
        word += static_cast<char>((rest_[0] - '0') * 64 + (rest_[1] - '0') * 8 + (rest_[2] - '0'));
        rest_.remove_prefix(3);
        return true;
    }

    void take_into(std::string& word)
    {
        word += rest_[0];
        rest_.remove_prefix(1);
    }

    std::string_view rest_;
};

} // namespace

std::string shell_word(std::string_view text)
{
    if (!text.empty() && text.find_first_not_of(plain_characters) == std::string_view::npos)
        return std::string(text);
    const bool escapes = std::any_of(text.begin(), text.end(), is_control);
    std::string quoted = escapes ? "$'" : "'";
    for (const char c : text)
        quoted += escapes ? escaped(c) : c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string shell_text(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + shell_word(word);
    return text;
}

std::optional<std::vector<std::string>> split_shell_words(std::string_view text)
{
    return ShellReader(text).words();
}

std::vector<std::string> split_outside_quotes(std::string_view text, std::string_view separator)
{
    std::vector<std::string> parts(1);
    char quote = 0; // ' inside '...', $ inside $'...'
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (quote == 0 && text.substr(i, separator.size()) == separator) {
            parts.emplace_back();
            i += separator.size() - 1;
            continue;
        }
        const bool escape = text[i] == '\\' && quote != '\'' && i + 1 < text.size();
        if (escape)
            parts.back() += text[i++];
        else if (text[i] == '\'')
            quote = quote != 0 ? '\0' : i > 0 && text[i - 1] == '$' ? '$' : '\'';
        parts.back() += text[i];
    }
    return parts;
}

} // namespace multipath
