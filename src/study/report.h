#pragma once

#include <string>
#include <variant>
#include <vector>

// A report of text, tables and figures, and its two forms: one HTML file that holds everything, and Markdown beside the
// figures' files. In all texts `...` is code and *...* is emphasis.

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
    std::string command; ///< that makes it
};

/// Figures side by side, as far as the page is wide enough.
struct ReportFigures
{
    std::vector<ReportFigure> figures;
};

using ReportBlock = std::variant<ReportHeading, ReportParagraph, ReportTable, ReportFigures>;
using Report = std::vector<ReportBlock>;

/// A page without any reference to another file. `folder` is where the figures lie; the comments stand at its head.
/// Throws InputError for a figure that cannot be read.
std::string report_html(const Report& report, const std::string& folder, const std::vector<std::string>& comments);

std::string report_markdown(const Report& report, const std::vector<std::string>& comments);

} // namespace multipath
