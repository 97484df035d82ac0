#include "study/report.h"

namespace multipath {

namespace {

/// Without the marks of what changes from run to run; in a cell, a bar would end it.
std::string plain(const std::string& text, bool cell = false)
{
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text.compare(i, 2, "{{") == 0 || text.compare(i, 2, "}}") == 0)
            ++i;
        else if (cell && text[i] == '|')
            result += "\\|";
        else
            result += text[i];
    return result;
}

class MarkdownWriter
{
public:
    explicit MarkdownWriter(const std::string& figures) : figures_(figures) {}

    std::string operator()(const ReportHeading& heading) const
    {
        return std::string(static_cast<std::size_t>(heading.level), '#') + " " + plain(heading.text) + "\n\n";
    }
    std::string operator()(const ReportParagraph& paragraph) const { return plain(paragraph.text) + "\n\n"; }
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
            text += "![" + figure.file + "](" + figures_ + figure.file + ")\n\n" + plain(figure.caption) +
                    "\n\n```console\n" + figure.command + "\n```\n\n";
        return text;
    }

private:
    static std::string row(const std::vector<std::string>& cells)
    {
        std::string text;
        for (const std::string& cell : cells)
            text += "| " + plain(cell, true) + " ";
        return text + "|\n";
    }

    std::string figures_;
};

} // namespace

std::string report_markdown(const Report& report, const std::string& figures, const std::vector<std::string>& comments)
{
    std::string text;
    for (const ReportBlock& block : report)
        text += std::visit(MarkdownWriter(figures), block);
    text += "---\n\n";
    for (const std::string& comment : comments)
        text += "    " + comment + "\n"; // as code: nothing in it is Markdown
    return text;
}

} // namespace multipath
