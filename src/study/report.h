#pragma once

#include <string>
#include <variant>
#include <vector>

// A report of text, tables and figures, written as one self-contained HTML file or as Markdown that refers to the files
// of the figures. In all texts `...` is code and *...* is emphasis.

namespace multipath {

struct ReportHeading
{
    int level = 2; ///< 1 is the title
    std::string text;
};

struct ReportParagraph
{
    std::string text;
};

/// Every row has as many cells as the header.
struct ReportTable
{
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
};

struct ReportFigure
{
    std::string file; ///< .svg or .png in the report's folder
    std::string caption;
    std::string command; ///< that made it
};

/// Figures side by side, as many in a row as the page has room for.
struct ReportFigures
{
    std::vector<ReportFigure> figures;
};

using ReportBlock = std::variant<ReportHeading, ReportParagraph, ReportTable, ReportFigures>;
using Report = std::vector<ReportBlock>;

/// The report as a self-contained page. `folder` is the folder of the figures; the comments go into the head of the
/// page. Throws InputError for a figure that cannot be read.
std::string report_html(const Report& report, const std::string& folder, const std::vector<std::string>& comments);

/// The report as Markdown; the comments are at its end.
std::string report_markdown(const Report& report, const std::vector<std::string>& comments);

} // namespace multipath
