#include "commands/result_difference.h"

#include "export/html_text.h"
#include "scene/text_lines.h"
#include "viewer/viewer_page.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::size_t shown_before = 15; ///< characters of a line that lead to where it differs

/// Where the texts part, with a piece of both lines; "" where they are equal.
std::string first_difference(const std::string& then, const std::string& now)
{
    const auto place = std::mismatch(then.begin(), then.end(), now.begin(), now.end()).first - then.begin();
    const auto at = static_cast<std::size_t>(place);
    if (at == then.size() && at == now.size())
        return "";
    const auto line = std::count(then.begin(), then.begin() + place, '\n') + 1;
    const std::size_t line_begin = at == 0 ? 0 : then.rfind('\n', at - 1) + 1;
    const std::size_t begin = std::max(line_begin, at - std::min(at, shown_before));
    const auto piece = [&](const std::string& text) {
        return in_quotes(text.substr(begin, text.find('\n', begin) - begin));
    };
    return "line " + std::to_string(line) + " differs: then " + piece(then) + ", now " + piece(now);
}

/// Removes what is between every `open` and the next `close`.
std::string emptied(const std::string& text, std::string_view open, std::string_view close)
{
    return replaced_between(text, open, close,
                            [&](const std::string&) { return std::string(open) + std::string(close); });
}

/// Line ends stay, so that messages count right.
std::string without_record(const std::string& drawing)
{
    const std::string_view record = drawing_record(drawing);
    if (record.empty())
        return drawing;
    const auto begin = static_cast<std::size_t>(record.data() - drawing.data());
    std::string text = drawing;
    return text.replace(begin, record.size(),
                        std::string(static_cast<std::size_t>(std::count(record.begin(), record.end(), '\n')), '\n'));
}

/// The same with the comments of an OBJ.
std::string without_comments(const std::string& obj)
{
    std::size_t begin = 0;
    std::string lines;
    for (; begin < obj.size() && obj[begin] == '#'; begin = std::min(obj.find('\n', begin), obj.size() - 1) + 1)
        lines += '\n';
    return lines + obj.substr(begin);
}

/// Without the drawings of figures with seconds across.
std::string without_times(const std::string& report)
{
    const std::string end = "</figure>";
    const std::string text = emptied(report, "<span class=\"run\">", "</span>");
    std::string result;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t figure = std::min(text.find("<figure ", from), text.size());
        const std::size_t next = std::min(text.find(end, figure), text.size());
        const std::string part = text.substr(figure, next - figure);
        result += text.substr(from, figure - from);
        result += part.find("--against seconds") == std::string::npos ? part : emptied(part, "<svg ", "</svg>");
        from = next;
        if (from < text.size()) {
            result += end;
            from += end.size();
        }
    }
    return result;
}

/// The report's own folder, in the commands of its figures, is another one each time.
std::string without_folder(std::string report)
{
    const std::string option = "--reference ";
    const std::string file = "/reference-";
    for (std::size_t at = report.find(option); at != std::string::npos; at = report.find(option, at)) {
        at += option.size();
        const std::size_t slash = report.find(file, at);
        if (slash >= report.find('\n', at))
            continue;
        const bool quoted = report[at] == '\'' || report[at] == '$';
        report.erase(at, slash + 1 - at);
        const std::size_t quote = report.find('\'', at);
        if (quoted && quote < report.find('\n', at))
            report.erase(quote, 1);
    }
    return report;
}

/// The room's data, without the line that repeats the record.
std::string room_data(const std::string& page)
{
    const std::size_t begin = page.find(room_data_begin);
    const std::string data =
        begin == std::string::npos ? "" : page.substr(begin, page.find(room_data_end, begin) - begin);
    return emptied(data, "\n  \"record\": ", "\n");
}

} // namespace

ResultDifference drawing_difference(const std::string& then, const std::string& now)
{
    return {first_difference(without_record(then), without_record(now))};
}

ResultDifference obj_difference(const std::string& then, const std::string& now)
{
    return {first_difference(without_comments(then), without_comments(now))};
}

ResultDifference page_difference(const std::string& then, const std::string& now)
{
    return {first_difference(room_data(then), room_data(now))};
}

ResultDifference report_difference(const std::string& then, const std::string& now)
{
    const auto result = [](const std::string& report) {
        return emptied(without_folder(report), html_record_begin, html_record_end);
    };
    const std::string before = result(then);
    const std::string after = result(now);
    const std::string text = first_difference(without_times(before), without_times(after));
    return {text, text.empty() && before != after};
}

ResultDifference result_difference(RecordedFile kind, const std::string& then, const std::string& now,
                                   const std::string& path)
{
    switch (kind) {
    case RecordedFile::ppm:
        return ppm_difference(then, now);
    case RecordedFile::png:
        return png_difference(then, now);
    case RecordedFile::drawing:
        return drawing_difference(then, now);
    case RecordedFile::report:
        return report_difference(then, now);
    case RecordedFile::page:
        return page_difference(then, now);
    case RecordedFile::ply:
        return ply_difference(then, now);
    case RecordedFile::glb:
        return glb_difference(then, now);
    case RecordedFile::obj:
        return obj_difference(then, now);
    case RecordedFile::table:
        break;
    }
    return table_difference(then, now, path);
}

} // namespace multipath
