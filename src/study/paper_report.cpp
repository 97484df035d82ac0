#include "study/paper_report.h"

#include "base/file_bytes.h"
#include "base/text_format.h"
#include "export/html_text.h"
#include "study/study_table.h"

namespace multipath {

namespace {

constexpr const char* style = R"(
body { margin: 0 auto; padding: 2rem 1.2rem 4rem; max-width: 62rem; color: #1c1c1c; background: #fdfdfb;
  font: 1rem/1.55 system-ui, sans-serif; }
p, figcaption { max-width: 44rem; }
h2 { margin-top: 2.6rem; border-top: 1px solid #d8d6cf; padding-top: 1.2rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .8rem .3rem 0; text-align: left; vertical-align: top; border-bottom: 1px solid #d8d6cf; }
code { background: #f1f0eb; font-size: .88em; overflow-wrap: anywhere; }
.figures { display: flex; flex-wrap: wrap; gap: 1.2rem; margin: 1.2rem 0; }
figure { margin: 0; flex: 0 1 29rem; }
figure svg, figure img { max-width: 100%; height: auto; background: #fff; }
figcaption, th, details { color: #66645e; font-size: .9rem; }
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

std::string html_row(const std::vector<std::string>& cells, const std::string& tag)
{
    std::string html = "<tr>";
    for (const std::string& cell : cells)
        html += "<" + tag + ">" + marked_up(cell) + "</" + tag + ">";
    return html + "</tr>\n";
}

std::string html_figure(const ReportFigure& figure, const std::string& folder)
{
    std::string drawing = bytes_of_file(folder + "/" + figure.file);
    if (figure.file.rfind(".svg") == std::string::npos)
        drawing = "<img alt=\"" + html_escaped(figure.caption) + "\" src=\"data:image/png;base64," + base64(drawing) +
                  "\">\n";
    return "<figure id=\"" + html_escaped(figure.file) + "\">\n" + drawing + "<figcaption>" +
           marked_up(figure.caption) + "<details><summary>command</summary><code>" + html_escaped(figure.command) +
           "</code></details></figcaption>\n</figure>\n";
}

std::string html_block(const ReportBlock& block, const std::string& folder)
{
    if (!block.table.empty()) {
        std::string html = "<div class=\"wide\"><table>\n";
        for (std::size_t k = 0; k < block.table.size(); ++k)
            html += html_row(block.table[k], k == 0 ? "th" : "td");
        return html + "</table></div>\n";
    }
    if (!block.figures.empty()) {
        std::string html = "<div class=\"figures\">\n";
        for (const ReportFigure& figure : block.figures)
            html += html_figure(figure, folder);
        return html + "</div>\n";
    }
    const std::string tag = block.heading > 0 ? "h" + std::to_string(block.heading) + ">" : "p>";
    return "<" + tag + marked_up(block.text) + "</" + tag + "\n";
}

/// A row of a table in Markdown: vertical bars in cells are escaped.
std::string markdown_row(const std::vector<std::string>& cells)
{
    std::string text;
    for (const std::string& cell : cells) {
        text += "| ";
        for (const char c : cell)
            text += c == '|' ? "\\|" : std::string(1, c);
        text += " ";
    }
    return text + "|\n";
}

std::string markdown_block(const ReportBlock& block)
{
    std::string text;
    if (!block.table.empty()) {
        const std::vector<std::string> rule(block.table[0].size(), "---");
        text = markdown_row(block.table[0]) + markdown_row(rule);
        for (std::size_t k = 1; k < block.table.size(); ++k)
            text += markdown_row(block.table[k]);
        return text + "\n";
    }
    for (const ReportFigure& figure : block.figures)
        text += "![" + figure.file + "](" + figure.file + ")\n\n" + figure.caption + "\n\n```console\n" +
                figure.command + "\n```\n\n";
    if (!block.figures.empty())
        return text;
    if (block.heading > 0)
        text = std::string(static_cast<std::size_t>(block.heading), '#') + " ";
    return text + block.text + "\n\n";
}

} // namespace

std::string report_html(const Report& report, const std::string& folder, const std::vector<std::string>& comments)
{
    std::string title = "multipath";
    std::string body;
    for (const ReportBlock& block : report) {
        if (block.heading == 1)
            title = block.text;
        body += html_block(block, folder);
    }
    std::string record;
    for (const std::string& comment : comments)
        record += "  " + html_record_line(comment);
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n  <meta charset=\"utf-8\">\n"
           "  <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
           record + "  <title>" + html_escaped(title) + "</title>\n  <style>" + style + "</style>\n</head>\n<body>\n" +
           body + "</body>\n</html>\n";
}

std::string report_markdown(const Report& report, const std::vector<std::string>& comments)
{
    std::string text;
    for (const ReportBlock& block : report)
        text += markdown_block(block);
    text += "---\n\n";
    for (const std::string& comment : comments)
        text += "    " + comment + "\n"; // indented as code, so that nothing in it is taken for Markdown
    return text;
}

namespace {

/// Builds the report, section by section.
class PaperReport
{
public:
    explicit PaperReport(const PaperFindings& findings) : f_(findings) {}

    void opening()
    {
        heading(1, "Quasi-Monte Carlo lines and the extended first shot, reproduced");
        text("Every table and figure of F. Castro, R. Martínez, M. Sbert: *Quasi Monte-Carlo and extended first shot "
             "improvements to the multi-path method for radiosity* (1998), and what `multipath` adds to them. Each "
             "figure names the command that makes it.");
        text("The paper's scenes were never published. The bundled ones match what it states of them: the number and "
             "kind of things in the room, and the figures that formula (3) takes. So orderings, slopes and ratios can "
             "be compared; absolute errors cannot.");
        ReportTable facts = {{"this run", ""},
                             {"set", f_.quick ? "quick: few lines, 3 executions for every point"
                                              : "full: the paper's numbers of lines, 6 executions for every point"}};
        for (const std::string& fact : f_.facts)
            facts.push_back({fact.substr(0, fact.find(": ")), fact.substr(fact.find(": ") + 2)});
        table(facts);
    }

    void claims()
    {
        heading(2, "In short");
        ReportTable claims = {{"statement", "paper", "here", ""}};
        for (const Claim& claim : paper_claims(f_))
            claims.push_back({claim.statement, claim.expected, claim.found,
                              claim.verdict == Verdict::differs ? "*differs*" : verdict_word(claim.verdict)});
        table(claims);
        text("Slopes are given with half the width of their 95 % interval (Student's t over the scatter of the points "
             "about the line), ratios with their standard error over the executions. A statement is undecided if the "
             "95 % interval contains values for and against it; more executions make it narrower. Errors are relative "
             "mean square errors, (1) over the square of the mean radiosity.");
    }

    void scenes()
    {
        heading(2, "The scenes and formula (3)");
        ReportTable scenes = {{"", "patches", "R_ave", "n_int", "f", "R_s'", "(3) first shot", "(3) extended"}};
        for (const SceneFindings* scene : {&f_.five_cubes, &f_.four_chairs, &f_.four_chairs_up})
            scenes.push_back(budget_row(scene->name, grouped(scene->patches), scene->report.figures,
                                        scene->report.ratio_first_shot, scene->report.ratio_extended, 3));
        for (const auto& [name, budget] :
             {std::pair{"*paper, lit downwards*", published_down}, {"*paper, lit upwards*", published_up}})
            scenes.push_back(budget_row(name, "", budget.figures, budget.ratio, published_extended.ratio, 2));
        table(scenes);
        text(
            "R_ave is the mean reflectance, n_int the number of surfaces that a line through the convex hull of the "
            "scene crosses, f the share of the area that the lamp lights, R_s' the mean reflectance of what it lights. "
            "The paper prints no such figures for 5CUBES. `multipath check SCENE` measures them.");
    }

    void generators()
    {
        heading(2, "Figures 1 and 2: points");
        figures(
            {{"figure1", "Figure 1. Random points leave holes and clusters, quasi-random ones do not."},
             {"figure2", "Figure 2. Successive points joined. (a) Halton, two 2-D items for a line: the next point "
                         "is always far away. (b) Random. (c), (d) one 4-D item of Halton's or Sobol's sequence for "
                         "each line: the correlation is gone."}});
        heading(2, "Two items for a line: why it fails");
        figures({{"pairs", "First shot on 5CUBES with one 4-D item or two successive 2-D items for a line."}});
        text("With pairs the two ends of a line are never close to each other, so the lines are not uniform, and the "
             "error remains however many lines there are: a bias, not noise. The paper calls it “enormous” and goes "
             "on with 4-D items.");
    }

    void table_1()
    {
        heading(2, "Table 1, Figures 3 and 4: the error against the number of lines");
        ReportTable slopes = {{"slope", "5CUBES: paper", "here", "deviation", "4CHAIRS: paper", "here", "deviation"},
                              slope_row({"random", -1.0, -1.0}, "−1 (theory)")};
        for (const PublishedSlope& row : published_slopes)
            slopes.push_back(slope_row(row, ""));
        table(slopes);
        figures({{"figure3", "Figure 3. 5CUBES."}, {"figure4", "Figure 4. 4CHAIRS."}});
        text(
            "The grey lines have the slopes −1, that of random sampling, and −1.25, which well-spread points reach on "
            "a "
            "function with jumps, such as visibility, in four dimensions. Bars are one standard error of the mean over "
            "the executions; a hollow mark is too close to the error of the reference to count.");
        text("*Where it differs.* The paper says neither how many patches its scenes have nor how many executions a "
             "slope is based on, and prints no intervals. Here, executions of a sequence without a seed take "
             "successive parts of it.");
        order();
    }

    void pictures()
    {
        heading(2, "Figure 5: the same number of lines, random and quasi-random");
        figures({{"figure5a", "(a) random, 266,000 lines"},
                 {"figure5b", "(b) Halton (11,13,17,19), 266,000 lines"},
                 {"figure5c", "(c) random, 532,000 lines"},
                 {"figure5d", "(d) Halton (11,13,17,19), 532,000 lines"}});
        text("4CHAIRS by first shot and global lines, lit downwards, every patch in its own colour. Look at the floor "
             "and at the walls behind the "
             "chairs: the quasi-random pictures have the noise of random ones with more lines.");
        heading(2, "Figure 6: little of the scene is lit");
        figures({{"figure6a", "(a) first shot"},
                 {"figure6b", "(b) extended first shot"},
                 {"figure6c", "(c) local Monte Carlo"}});
        text("The lamp shines at the ceiling; 1.5 million lines each. After the first shot all power sits on the "
             "ceiling, which few global lines meet, and the picture is blotchy. The extended first shot spreads it "
             "first.");
    }

    void shots()
    {
        heading(2, "Figures 7, 8 and 9: first shot, extended first shot, local Monte Carlo");
        figures({{"figure7", "Figure 7. Lit upwards."},
                 {"figure8", "Figure 8. Lit upwards, without the first shot."},
                 {"figure9", "Figure 9. Lit downwards."}});
        table(shot_table());
        text("Random lines; each method splits its lines between local and global ones by (3). The paper measures "
             "against one run of local Monte Carlo with 16 million rays. That reference is itself only about ten times "
             "as good as what it judges, so the table has two columns: against a solution by line reuse, and against "
             "local Monte Carlo as in the paper. Where they agree the orderings do not depend on the judge.");
    }

    void beyond()
    {
        heading(2, "Beyond the paper: line reuse");
        figures({{"reuse-5cubes", "5CUBES"},
                 {"reuse-4chairs", "4CHAIRS, lit downwards"},
                 {"reuse-4chairs-up", "4CHAIRS, lit upwards"}});
        figures({{"reuse-5cubes-seconds", "5CUBES, against processor time"},
                 {"reuse-4chairs-seconds", "4CHAIRS, lit downwards"},
                 {"reuse-4chairs-up-seconds", "4CHAIRS, lit upwards"}});
        ReportTable gains = {
            {"at the most lines", "extended, Sobol (Owen)", "reuse, Sobol (Owen)", "gain", "slope of reuse"}};
        for (const auto& [file, name] : {std::pair{"reuse-5cubes", "5CUBES"},
                                         {"reuse-4chairs", "4CHAIRS, downwards"},
                                         {"reuse-4chairs-up", "4CHAIRS, upwards"}})
            gains.push_back(reuse_row(file, name));
        table(gains);
        text("The paper's methods forget a line once it has carried power. Line reuse counts which patches the lines "
             "join and then solves a linear system (docs/beyond.md). Its curves fall more steeply than the limit of "
             "−1.25 "
             "where "
             "not only the visibility of each pair but also what is known of its neighbours improves with the lines.");
        text(
            "Times are processor time of one thread, what a run computes before its first line included: for line "
            "reuse the form factors without obstacles, a fixed amount. Against time the curves of line reuse therefore "
            "begin late and fall at once.");
    }

    Report report;

private:
    void heading(int level, const std::string& words) { report.push_back({level, words}); }
    void text(const std::string& words) { report.push_back({0, words}); }
    void table(const ReportTable& rows) { report.push_back({0, "", rows}); }

    /// Appends figures: pairs of a file name without extension and a caption.
    void figures(const std::vector<std::pair<std::string, std::string>>& wanted)
    {
        std::vector<ReportFigure> row;
        for (const auto& [name, caption] : wanted) {
            const std::string file = name + (f_.commands.count(name + ".svg") > 0 ? ".svg" : ".png");
            row.push_back({file, caption, f_.commands.at(file)});
        }
        report.push_back({0, "", {}, row});
    }

    /// A row on formula (3); `decimals`: of its result and of R_s' and, but for one, of n_int.
    static std::vector<std::string> budget_row(const std::string& name, const std::string& patches,
                                               const BudgetFigures& b, const std::optional<double>& first_shot,
                                               const std::optional<double>& extended, int decimals)
    {
        const auto ratio = [&](const std::optional<double>& r) { return r ? fixed(*r, decimals) : "–"; };
        return {name,
                patches,
                fixed(b.average_reflectance, 3),
                fixed(b.intersections, decimals - 1),
                fixed(b.lit_fraction, 3),
                fixed(b.secondary_reflectance, decimals),
                ratio(first_shot),
                ratio(extended)};
    }

    /// `instead`: text in place of the published slopes; empty: the slopes.
    std::vector<std::string> slope_row(const PublishedSlope& published, const std::string& instead) const
    {
        std::vector<std::string> row = {published.sequence};
        for (const auto& [name, printed] :
             {std::pair{"figure3", published.five_cubes}, {"figure4", published.four_chairs}}) {
            const auto law = curve_of(f_.study(name), "first-shot", published.sequence).law;
            row.push_back(instead.empty() ? fixed(printed, 3) : instead);
            row.push_back(slope_words(law));
            row.push_back(law ? fixed(law->exponent - printed, 3) : "");
        }
        return row;
    }

    void order()
    {
        heading(2, "Why Halton's slopes depend on bases and scene: the order of the lines");
        figures(
            {{"order", "5CUBES with patches of 0.5: the same lines in the order of the sequence and shuffled in blocks "
                       "of 4,096."}});
        ReportTable orders = {
            {"slope, patches of 0.5", "in order", "shuffled", "error at the most lines, in order / shuffled"}};
        for (const PublishedSlope& row : published_slopes) {
            const Curve& in_order = curve_of(f_.study("order"), "first-shot", row.sequence, "sequence");
            const Curve& shuffled = curve_of(f_.study("order"), "first-shot", row.sequence, "shuffled");
            orders.push_back({row.sequence, slope_words(in_order.law), slope_words(shuffled.law),
                              fixed(in_order.points.back().relative / shuffled.points.back().relative, 2)});
        }
        table(orders);
        text("The paper finds that the best bases change from scene to scene and leaves the question open. The answer: "
             "what a line of the multi-path walk carries depends on the lines before it. Successive items of a "
             "quasi-random sequence are not independent, so the lines that meet a patch one after the other are "
             "correlated, and the walk converges to something slightly wrong. The fewer the patches, the fewer other "
             "lines "
             "come between two that meet the same one, the larger the error, and the earlier the curve flattens; large "
             "bases, whose digits change slowly, suffer most. It is a bias of the walk, not a matter of discrepancy: "
             "with the same lines in shuffled order it is gone, and all sequences have nearly the same slope. "
             "`multipath` shuffles unless told otherwise (line order `sequence`).");
    }

    ReportTable shot_table() const
    {
        ReportTable table = {
            {"relative MSE at " + grouped(f_.study("figure7").curves[0].points.back().lines) + " lines", "lit upwards",
             "against local Monte Carlo", "lit downwards", "against local Monte Carlo"}};
        for (const char* method : {"first-shot", "extended", "local"}) {
            std::vector<std::string> row = {method};
            for (const char* study : {"figure7", "figure7-local", "figure9", "figure9-local"}) {
                const CurvePoint& point = curve_of(f_.study(study), method, "random").points.back();
                row.push_back(scientific(point.relative) + " ± " +
                              fixed(100.0 * point.relative_error / point.relative, 0) + " %");
            }
            table.push_back(row);
        }
        return table;
    }

    std::vector<std::string> reuse_row(const std::string& file, const std::string& name) const
    {
        const Curve& extended = curve_of(f_.study(file), "extended", "sobol-owen");
        const Curve& reuse = curve_of(f_.study(file), "reuse", "sobol-owen");
        return {name + ", " + grouped(reuse.points.back().lines), scientific(extended.points.back().relative),
                scientific(reuse.points.back().relative),
                fixed(extended.points.back().relative / reuse.points.back().relative, 0), slope_words(reuse.law)};
    }

    const PaperFindings& f_;
};

} // namespace

Report paper_report(const PaperFindings& findings)
{
    PaperReport paper(findings);
    paper.opening();
    paper.claims();
    paper.scenes();
    paper.generators();
    paper.table_1();
    paper.pictures();
    paper.shots();
    paper.beyond();
    return paper.report;
}

} // namespace multipath
