#include "study/report.h"

#include "export/file_bytes.h"
#include "export/html_text.h"

namespace multipath {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --ink: #1c1c1c; --paper: #fdfdfb; --faint: #66645e; --rule: #d8d6cf; --code: #f1f0eb; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e4de; --paper: #191a1c; --faint: #a09d95; --rule: #3c3d40; --code: #26282b; } }
body { margin: 0 auto; padding: 2rem 1.2rem 4rem; max-width: 62rem; color: var(--ink); background: var(--paper);
  font: 1rem/1.55 system-ui, sans-serif; }
p, li { max-width: 44rem; }
h1 { font-size: 1.8rem; line-height: 1.2; } h2 { margin-top: 2.6rem; border-top: 1px solid var(--rule); padding-top: 1.2rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .8rem .3rem 0; text-align: left; vertical-align: top; border-bottom: 1px solid var(--rule); }
th { color: var(--faint); font-weight: 600; }
code { background: var(--code); padding: .1rem .25rem; border-radius: 3px; font-size: .88em; overflow-wrap: anywhere; }
.figures { display: flex; flex-wrap: wrap; gap: 1.2rem; margin: 1.2rem 0; }
figure { margin: 0; flex: 1 1 22rem; max-width: 100%; }
.three figure { flex-basis: 17rem; }
figure svg, figure img { display: block; max-width: 100%; height: auto; border-radius: 4px; background: #fff; }
figcaption { margin-top: .5rem; color: var(--faint); font-size: .92rem; max-width: 44rem; }
details { margin-top: .2rem; font-size: .85rem; } summary { cursor: pointer; }
@media print { details { display: none; } body { max-width: none; } }
)";

/// Replaces each pair of a mark by the tags of an element.
std::string tagged(const std::string& text, char mark, const std::string& element)
{
    std::string result;
    std::size_t from = 0;
    for (;;) {
        const std::size_t open = text.find(mark, from);
        const std::size_t close = open == std::string::npos ? open : text.find(mark, open + 1);
        if (close == std::string::npos)
            return result + text.substr(from);
        result += text.substr(from, open - from) + "<" + element + ">" + text.substr(open + 1, close - open - 1) +
                  "</" + element + ">";
        from = close + 1;
    }
}

std::string marked_up(const std::string& text)
{
    return tagged(tagged(html_escaped(text), '`', "code"), '*', "em");
}

bool ends_with(const std::string& text, const std::string& end)
{
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

class HtmlWriter
{
public:
    explicit HtmlWriter(const std::string& folder) : folder_(folder) {}

    std::string operator()(const ReportHeading& heading) const
    {
        const std::string tag = "h" + std::to_string(heading.level) + ">";
        return "<" + tag + marked_up(heading.text) + "</" + tag + "\n";
    }
    std::string operator()(const ReportParagraph& paragraph) const
    {
        return "<p>" + marked_up(paragraph.text) + "</p>\n";
    }
    std::string operator()(const ReportTable& table) const
    {
        std::string html = "<div class=\"wide\"><table>\n" + row(table.header, "th");
        for (const std::vector<std::string>& cells : table.rows)
            html += row(cells, "td");
        return html + "</table></div>\n";
    }
    std::string operator()(const ReportFigures& figures) const
    {
        const bool three_pictures = figures.figures.size() == 3 && ends_with(figures.figures[0].file, ".png");
        std::string html = std::string("<div class=\"figures") + (three_pictures ? " three" : "") + "\">\n";
        for (const ReportFigure& figure : figures.figures)
            html += "<figure id=\"" + html_escaped(figure.file) + "\">\n" + drawing(figure) + "<figcaption>" +
                    marked_up(figure.caption) + "<details><summary>command</summary><code>" +
                    html_escaped(figure.command) + "</code></details></figcaption>\n</figure>\n";
        return html + "</div>\n";
    }

private:
    static std::string row(const std::vector<std::string>& cells, const std::string& tag)
    {
        std::string html = "<tr>";
        for (const std::string& cell : cells)
            html += "<" + tag + ">" + marked_up(cell) + "</" + tag + ">";
        return html + "</tr>\n";
    }
    std::string drawing(const ReportFigure& figure) const
    {
        std::string bytes = bytes_of_file(folder_ + "/" + figure.file);
        if (ends_with(figure.file, ".svg"))
            return bytes;
        return "<img alt=\"" + html_escaped(figure.caption) + "\" src=\"data:image/png;base64," + base64(bytes) +
               "\">\n";
    }

    std::string folder_;
};

std::string record(const std::vector<std::string>& comments)
{
    std::string text;
    for (const std::string& comment : comments)
        text += "  " + html_record_line(comment);
    return text;
}

/// Text of a table cell in Markdown: vertical bars are escaped.
std::string cell_text(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '|' ? "\\|" : std::string(1, c);
    return result;
}

class MarkdownWriter
{
public:
    std::string operator()(const ReportHeading& heading) const
    {
        return std::string(static_cast<std::size_t>(heading.level), '#') + " " + heading.text + "\n\n";
    }
    std::string operator()(const ReportParagraph& paragraph) const { return paragraph.text + "\n\n"; }
    std::string operator()(const ReportTable& table) const
    {
        std::string text = row(table.header);
        for (std::size_t k = 0; k < table.header.size(); ++k)
            text += "| --- ";
        text += "|\n";
        for (const std::vector<std::string>& cells : table.rows)
            text += row(cells);
        return text + "\n";
    }
    std::string operator()(const ReportFigures& figures) const
    {
        std::string text;
        for (const ReportFigure& figure : figures.figures)
            text += "![" + figure.file + "](" + figure.file + ")\n\n" + figure.caption + "\n\n```console\n" +
                    figure.command + "\n```\n\n";
        return text;
    }

private:
    static std::string row(const std::vector<std::string>& cells)
    {
        std::string text;
        for (const std::string& cell : cells)
            text += "| " + cell_text(cell) + " ";
        return text + "|\n";
    }
};

} // namespace

std::string report_html(const Report& report, const std::string& folder, const std::vector<std::string>& comments)
{
    std::string title = "multipath";
    for (const ReportBlock& block : report)
        if (const auto* heading = std::get_if<ReportHeading>(&block); heading != nullptr && heading->level == 1)
            title = heading->text;
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n  <meta charset=\"utf-8\">\n"
                       "  <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
                       record(comments) + "  <title>" + html_escaped(title) + "</title>\n  <style>" + style +
                       "</style>\n</head>\n<body>\n";
    for (const ReportBlock& block : report)
        html += std::visit(HtmlWriter(folder), block);
    return html + "</body>\n</html>\n";
}

std::string report_markdown(const Report& report, const std::vector<std::string>& comments)
{
    std::string text;
    for (const ReportBlock& block : report)
        text += std::visit(MarkdownWriter(), block);
    text += "---\n\n";
    for (const std::string& comment : comments)
        text += "    " + comment + "\n"; // indented as code, so that nothing in it is taken for Markdown
    return text;
}

} // namespace multipath
