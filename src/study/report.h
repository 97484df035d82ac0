#pragma once

#include <string>
#include <variant>
#include <vector>

// A report of text, tables and figures, written as one self-contained HTML file or as Markdown that refers to the files
// of the figures. In headings, paragraphs, cells and captions `...` is code and *...* is emphasis.

namespace multipath {

struct ReportHeading
{
    int level = 2; ///< 1 for the title, 2 for a section
    std::string text;
};

struct ReportParagraph
{
    std::string text;
};

/// A table. Every row must have as many cells as the header.
struct ReportTable
{
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
};

struct ReportFigure
{
    std::string file; ///< name of the .svg or .png file in the folder of the report
    std::string caption;
    std::string command; ///< command line that made the file
};

/// Figures side by side, as many in a row as fit into the width of the page.
struct ReportFigures
{
    std::vector<ReportFigure> figures;
};

using ReportBlock = std::variant<ReportHeading, ReportParagraph, ReportTable, ReportFigures>;
using Report = std::vector<ReportBlock>;

/// Formats the report as a self-contained HTML page. `folder` is the folder that holds the files of the figures. The
/// comments go into the head of the page. Throws InputError if the file of a figure cannot be read.
std::string report_html(const Report& report, const std::string& folder, const std::vector<std::string>& comments);

/// Formats the report as Markdown. The comments are at its end.
std::string report_markdown(const Report& report, const std::vector<std::string>& comments);

} // namespace multipath
