#include "commands/recorded_command.h"

#include "cli/shell_words.h"
#include "export/comments.h"
#include "export/html_text.h"
#include "image/png_chunks.h"
#include "scene/input_error.h"
#include "scene/text_lines.h"
#include "viewer/viewer_page.h"

#include <algorithm>

namespace multipath {

namespace {

using Facts = std::vector<std::string>;

bool starts_with(std::string_view text, std::string_view start)
{
    return text.substr(0, start.size()) == start;
}

/// What is before the line's end; takes it off the text.
std::string_view take_line(std::string_view& text)
{
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    return line;
}

Facts facts_of_table(std::string_view text)
{
    Facts facts;
    while (starts_with(text, "#")) {
        const std::string_view line = take_line(text);
        facts.emplace_back(line.substr(std::min<std::size_t>(starts_with(line, "# ") ? 2 : 1, line.size())));
    }
    return facts;
}

/// Pictures have all parts in one comment.
Facts facts_of_comment(std::string_view comment)
{
    return split_outside_quotes(comment, "; ");
}

Facts facts_of_ppm(std::string_view bytes)
{
    take_line(bytes);
    return starts_with(bytes, "# ") ? facts_of_comment(take_line(bytes).substr(2)) : Facts{};
}

Facts facts_of_png(std::string_view bytes)
{
    const std::optional<std::string_view> comment = png_comment(bytes);
    return comment ? facts_of_comment(*comment) : Facts{};
}

Facts facts_of_drawing(std::string_view bytes)
{
    Facts facts;
    for (std::string_view record = drawing_record(bytes); !record.empty();)
        facts.push_back(html_unescaped(take_line(record)));
    return facts;
}

Facts facts_of_report(std::string_view bytes)
{
    Facts facts;
    std::string_view head = bytes.substr(0, bytes.find("</head>"));
    for (;;) {
        const std::size_t begin = head.find(html_record_begin);
        if (begin == std::string_view::npos)
            return facts;
        head.remove_prefix(begin + html_record_begin.size());
        facts.push_back(html_unescaped(head.substr(0, head.find(html_record_end))));
    }
}

Facts facts_of_ply(std::string_view bytes)
{
    constexpr std::string_view keyword = "comment ";
    Facts facts;
    for (std::string_view line = take_line(bytes); !bytes.empty() && line != "end_header"; line = take_line(bytes))
        if (starts_with(line, keyword))
            facts.emplace_back(line.substr(keyword.size()));
    return facts;
}

/// Takes a text with its quotes off a list in JSON. Of escapes it knows those that the program writes; \u stays.
std::string take_text(std::string_view& list)
{
    std::string text;
    std::size_t at = list.find('"') + 1;
    for (; at < list.size() && list[at] != '"'; ++at) {
        const bool escape = list[at] == '\\' && at + 1 < list.size() && list[at + 1] != 'u';
        at += escape ? 1 : 0;
        text += list[at];
    }
    list.remove_prefix(std::min(at + 1, list.size()));
    return text;
}

Facts facts_of_glb(std::string_view bytes)
{
    Facts facts;
    std::string_view record = glb_record(bytes);
    while (record.find('"') != std::string_view::npos)
        facts.push_back(take_text(record));
    return facts;
}

/// A table and an OBJ both begin with comments.
bool is_obj(std::string_view bytes)
{
    while (starts_with(bytes, "#"))
        take_line(bytes);
    return starts_with(bytes, "v ");
}

RecordedFile kind_of(std::string_view bytes, const std::string& path)
{
    if (is_png(bytes))
        return RecordedFile::png;
    if (starts_with(bytes, "P6\n"))
        return RecordedFile::ppm;
    if (starts_with(bytes, "<svg "))
        return RecordedFile::drawing;
    if (starts_with(bytes, viewer_page_begin))
        return RecordedFile::page;
    if (starts_with(bytes, "<!DOCTYPE html>"))
        return RecordedFile::report;
    if (starts_with(bytes, "PF\n") || starts_with(bytes, "Pf\n"))
        throw InputError(path + ": a PFM keeps no record of its command; expected a PNG, PPM or CSV of the same run");
    if (starts_with(bytes, "ply\n"))
        return RecordedFile::ply;
    if (starts_with(bytes, "glTF"))
        return RecordedFile::glb;
    return is_obj(bytes) ? RecordedFile::obj : RecordedFile::table;
}

Facts facts_of(RecordedFile kind, std::string_view bytes)
{
    switch (kind) {
    case RecordedFile::ppm:
        return facts_of_ppm(bytes);
    case RecordedFile::png:
        return facts_of_png(bytes);
    case RecordedFile::drawing:
        return facts_of_drawing(bytes);
    case RecordedFile::report:
    case RecordedFile::page:
        return facts_of_report(bytes);
    case RecordedFile::ply:
        return facts_of_ply(bytes);
    case RecordedFile::glb:
        return facts_of_glb(bytes);
    case RecordedFile::obj:
    case RecordedFile::table:
        break;
    }
    return facts_of_table(bytes);
}

} // namespace

std::string_view drawing_record(std::string_view bytes)
{
    constexpr std::string_view tag = "<desc>";
    const std::size_t begin = bytes.find(tag);
    const std::size_t end = begin == std::string_view::npos ? begin : bytes.find("</desc>", begin);
    return end == std::string_view::npos ? "" : bytes.substr(begin + tag.size(), end - begin - tag.size());
}

std::string_view glb_record(std::string_view bytes)
{
    constexpr std::string_view key = "\"record\": [";
    const std::size_t key_begin = bytes.find(key);
    if (key_begin == std::string_view::npos)
        return "";
    const std::size_t begin = key_begin + key.size();
    bool inside = false; // a text, which may have brackets
    for (std::size_t at = begin; at < bytes.size(); ++at) {
        if (inside && bytes[at] == '\\')
            ++at;
        else if (bytes[at] == '"')
            inside = !inside;
        else if (!inside && bytes[at] == ']')
            return bytes.substr(begin, at - begin);
    }
    return "";
}

RecordedCommand read_recorded_command(const std::string& bytes, const std::string& path)
{
    const RecordedFile kind = kind_of(bytes, path);
    const Facts facts = facts_of(kind, bytes);
    const std::optional<std::string> command = comment_value(facts, "command");
    if (!command)
        throw InputError(path +
                         ": no record of a multipath command in it; expected a CSV, SVG, PNG, PPM, PLY, GLB, OBJ "
                         "or report (index.html) that multipath wrote");
    const std::optional<std::vector<std::string>> words = split_shell_words(*command);
    if (!words)
        throw InputError(path + ": expected a command of plain and quoted words in its record, got " +
                         in_quotes(*command));
    if (words->size() < 2 || words->front() != "multipath")
        throw InputError(path + ": expected a multipath command in its record, got " + in_quotes(*command));
    const auto is_version = [](const std::string& fact) { return starts_with(fact, "multipath "); };
    const auto version = std::find_if(facts.begin(), facts.end(), is_version);
    return {kind,
            version == facts.end() ? "" : *version,
            {words->begin() + 1, words->end()},
            comment_value(facts, "seed"),
            comment_value(facts, "scene")};
}

} // namespace multipath
