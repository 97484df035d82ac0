#include "study/paper_report.h"

#include "base/file_bytes.h"
#include "base/text_format.h"
#include "export/html_text.h"
#include "study/study_table.h"

#include <algorithm>

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
nav ol { padding-left: 2rem; font-size: .9rem; }
.up { position: fixed; right: 1rem; bottom: 1rem; padding: .2rem .8rem; border-radius: .6rem; background: #f1f0eb; }
@media (min-width: 80rem) {
  body { margin-left: max(18rem, calc(50vw - 31rem)); }
  nav { position: fixed; top: 1rem; bottom: 1rem; left: 1rem; width: 15rem; overflow-y: auto; }
  .up { display: none; }
}
)";

/// A row of a table: its cells as `tag`, th or td.
std::string row_of(const std::vector<std::string>& cells, const std::string& tag)
{
    std::string html = "<tr>";
    for (const std::string& cell : cells)
        html += "<" + tag + ">" + cell + "</" + tag + ">";
    return html + "</tr>\n";
}

/// Rows of cells, the first of which is the header. All have the same number of cells.
using ReportTable = std::vector<std::vector<std::string>>;

/// Builds the report, section by section.
class PaperReport
{
public:
    PaperReport(const PaperFindings& findings, const std::string& folder) : f_(findings), folder_(folder) {}

    void opening()
    {
        heading(1, "Quasi-Monte Carlo lines and the extended first shot, reproduced");
        text("Every table and figure of F. Castro, R. Martínez, M. Sbert: <em>Quasi Monte-Carlo and extended first "
             "shot improvements to the multi-path method for radiosity</em> (1998), and what <code>multipath</code> "
             "adds to them. Each figure names the command that makes it.");
        text("The paper's scenes were never published. The bundled ones match what it states of them: the number and "
             "kind of things in the room, and the figures that formula (3) takes. So orderings, slopes and ratios can "
             "be compared; absolute errors cannot.");
    }

    void claims()
    {
        heading(2, "In short");
        claim_table({"statement", "paper", "here", ""}, paper_claims(f_));
        text("Slopes and ratios are given with half the width of their 95 % interval: Student's t over the scatter of "
             "the points about the line, or of the executions. A statement is undecided if the interval contains "
             "values for and against it; more executions make it narrower. Errors are relative mean square errors, "
             "(1) over the square of the mean radiosity.");
    }

    void scenes()
    {
        heading(2, "The scenes and formula (3)");
        ReportTable scenes = {{"", "patches", "R_ave", "n_int", "f", "R_s'", "(3) first shot", "(3) extended"}};
        for (const SceneFindings* scene : {&f_.five_cubes, &f_.four_chairs, &f_.four_chairs_up})
            scenes.push_back(budget_row(scene->name, grouped(scene->patches), scene->report.figures,
                                        scene->report.ratio_first_shot, scene->report.ratio_extended, 3));
        for (const auto& [name, budget] : {std::pair{"<em>paper, lit downwards</em>", published_down},
                                           {"<em>paper, lit upwards</em>", published_up}})
            scenes.push_back(budget_row(name, "", budget.figures, budget.ratio, published_extended.ratio, 2));
        table(scenes);
        text("R_ave is the mean reflectance, n_int the number of surfaces that a line through the bounding box of the "
             "scene crosses, f the share of the area that the lamp lights, R_s' the mean reflectance of what it "
             "lights. The paper prints no such figures for 5CUBES. <code>multipath check SCENE</code> measures them.");
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
             "error remains however many lines there are: a bias, not noise. The paper calls it “enormous” and goes on "
             "with 4-D items.");
    }

    void table_1()
    {
        heading(2, "Table 1, Figures 3 and 4: the error against the number of lines");
        ReportTable slopes = {{"slope", "5CUBES: paper", "here", "4CHAIRS: paper", "here"},
                              slope_row({"random", -1.0, -1.0})};
        for (const PublishedSlope& row : published_slopes)
            slopes.push_back(slope_row(row));
        table(slopes);
        figures({{"figure3", "Figure 3. 5CUBES."}, {"figure4", "Figure 4. 4CHAIRS."}});
        text("The −1 of random lines is theory. The paper says neither how many patches its scenes have nor how many "
             "executions a slope is based on, and prints no intervals. Here, executions of a sequence without a seed "
             "take successive parts of it.");
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
             "and at the walls behind the chairs: the quasi-random pictures have the noise of random ones with more "
             "lines.");
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
        scene_figures("reuse-", 3);
        scene_figures("reuse-", 3, "-seconds");
        ReportTable gains = {
            {"at the most lines", "extended, Sobol (Owen)", "reuse, Sobol (Owen)", "gain", "slope of reuse"}};
        for (std::size_t k = 0; k < 3; ++k)
            gains.push_back(reuse_row(std::string("reuse-") + report_scenes[k][0], report_scenes[k][1]));
        table(gains);
        text("The paper's methods forget a line once it has carried power. Line reuse counts which patches the lines "
             "join and then solves a linear system (docs/beyond.md). With a table of all pairs, which pays where there "
             "are few patches, its curves fall more steeply than the limit of −1.25 where what is known of a pair's "
             "neighbours improves with the lines, too.");
        text("Against processor time the curves of line reuse begin late and fall at once: before its first line a run "
             "computes the form factors without obstacles, a fixed amount.");
    }

    void open_questions()
    {
        heading(2, "Open questions: the ratio of local to global lines");
        text("The paper asks for a better rule than (3). Here the number of lines is fixed and their division varies. "
             "The curves a / N_l + b / N_g are fitted to each execution. They are an approximation: global lines carry "
             "the noise of the local ones, a term in 1 / (N_l N_g), an extended first shot ends its passes by whole "
             "lines, and the error of Sobol's lines falls faster. (3) expects that the lit patches hold equal unshot "
             "power (f, R_s'), and after an extended first shot all patches. A pilot of the larger of 4,096 rays and "
             "two for each patch, at most a sixteenth of the lines, shows a and b of the scene itself (V1) (V2); its "
             "rays are not counted here. PowerByLine, which the user sets in the paper, is the same freedom: rays with "
             "the power Φ_s in all are N_l = Φ_s / PowerByLine (docs/method.md, section 6).");
        scene_figures("ratio-", report_scenes.size());
        const std::vector<Claim> formula = ratio_claims(f_, "auto");
        const std::vector<Claim> pilot = ratio_claims(f_, "measured");
        claim_table({"by (3)", "least error at", "ratio: error over the least", "at most 3 % more"}, formula);
        claim_table({"by a pilot", "error of (3) over the pilot's", "ratio: error over the least", "at most 3 % more"},
                    pilot);
        text("All points of an execution are the same lines divided differently. So the intervals in brackets (95 %) "
             "are Student's t over the executions (jackknife), and (3) and the pilot are compared execution by "
             "execution. p is the probability, if the law holds, that a constant beside a / N_l + b / N_g is as far "
             "from 0 as here (t test over the executions). Where p is below 0.05, or the least error of an execution "
             "is at none of the ratios, the law is given up, and the least measured point is taken (“measured”). That "
             "its error is at most 3 % above the least holds for (3) in " +
             count_that_hold(formula) + ", for the pilot in " + count_that_hold(pilot) + " cases.");
        heading(2, "A question of ours: the threshold");
        scene_figures("threshold-", 3);
        const std::vector<Claim> claims = threshold_claims(f_);
        claim_table({"extended first shot: error over that of (4)", "at a quarter of (4); at 4 times",
                     "at 0; at 16 times", "both worse than (4)"},
                    claims);
        text("Every threshold above 0 has the ratio of a pilot; ± is half the 95 % interval. A threshold of 0 is "
             "progressive "
             "ray refinement (Feda and Purgathofer 1993, Shirley 1991): all lines are local. A large one leaves the "
             "light where the sources threw it. That (4) is better than these two extremes holds in " +
             count_that_hold(claims) + " cases.");
    }

    std::string html;
    std::string contents; ///< items of a list, links to the sections

private:
    /// Such as "3 of 8".
    static std::string count_that_hold(const std::vector<Claim>& claims)
    {
        const auto holds = [](const Claim& claim) { return claim.verdict == Verdict::holds; };
        return format("%d of %zu", static_cast<int>(std::count_if(claims.begin(), claims.end(), holds)), claims.size());
    }

    void heading(int level, const std::string& words)
    {
        const std::string tag = "h" + std::to_string(level);
        const std::string place = "part-" + std::to_string(++headings_);
        html += "<" + tag + " id=\"" + place + "\">" + words + "</" + tag + ">\n";
        if (level > 1)
            contents += "<li><a href=\"#" + place + "\">" + words + "</a></li>";
    }

    void text(const std::string& words) { html += "<p>" + words + "</p>\n"; }

    void table(const ReportTable& rows)
    {
        html += "<div class=\"wide\"><table>\n";
        for (std::size_t k = 0; k < rows.size(); ++k)
            html += row_of(rows[k], k == 0 ? "th" : "td");
        html += "</table></div>\n";
    }

    void claim_table(const std::vector<std::string>& header, const std::vector<Claim>& claims)
    {
        constexpr std::array<const char*, 3> verdicts = {"holds", "undecided", "differs"};
        ReportTable rows = {header};
        for (const Claim& claim : claims)
            rows.push_back(
                {claim.statement, claim.expected, claim.found, verdicts[static_cast<std::size_t>(claim.verdict)]});
        table(rows);
    }

    /// Figures side by side: pairs of a file name without extension and a caption.
    void figures(const std::vector<std::pair<std::string, std::string>>& wanted)
    {
        html += "<div class=\"figures\">\n";
        for (const auto& [name, caption] : wanted) {
            const bool drawing = f_.commands.count(name + ".svg") > 0;
            const std::string file = name + (drawing ? ".svg" : ".png");
            const std::string bytes = bytes_of_file(folder_ + "/" + file);
            html += "<figure id=\"" + file + "\">\n" +
                    (drawing ? bytes
                             : "<img alt=\"" + html_escaped(caption) + "\" src=\"data:image/png;base64," +
                                   base64(bytes) + "\">\n") +
                    "<figcaption>" + caption + "<details><summary>command</summary><code>" +
                    html_escaped(f_.commands.at(file)) + "</code></details></figcaption>\n</figure>\n";
        }
        html += "</div>\n";
    }

    /// Of the first `count` scenes: files whose names begin and end like this.
    void scene_figures(const std::string& begin, std::size_t count, const std::string& end = "")
    {
        std::vector<std::pair<std::string, std::string>> wanted;
        for (std::size_t k = 0; k < count; ++k)
            wanted.emplace_back(begin + report_scenes[k][0] + end, report_scenes[k][1]);
        figures(wanted);
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

    std::vector<std::string> slope_row(const PublishedSlope& published) const
    {
        const auto slope = [&](const char* study) {
            return slope_words(curve_of(f_.study(study), "first-shot", published.sequence).law);
        };
        return {published.sequence, fixed(published.five_cubes, 3), slope("figure3"), fixed(published.four_chairs, 3),
                slope("figure4")};
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
             "lines come between two that meet the same one, the larger the error, and the earlier the curve flattens; "
             "large bases, whose digits change slowly, suffer most. It is a bias of the walk, not a matter of "
             "discrepancy: with the same lines in shuffled order it is gone, and all sequences have nearly the same "
             "slope. <code>multipath</code> shuffles unless told otherwise (line order <code>sequence</code>).");
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
                row.push_back(format("%.1e", point.relative) + " ± " +
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
        return {name + ", " + grouped(reuse.points.back().lines), format("%.1e", extended.points.back().relative),
                format("%.1e", reuse.points.back().relative),
                fixed(extended.points.back().relative / reuse.points.back().relative, 0), slope_words(reuse.law)};
    }

    const PaperFindings& f_;
    const std::string& folder_;
    int headings_ = 0;
};

} // namespace

std::string paper_report(const PaperFindings& findings, const std::string& folder,
                         const std::vector<std::string>& comments)
{
    std::string record;
    for (const std::string& comment : comments)
        record += "  " + html_record_line(comment);
    PaperReport paper(findings, folder);
    paper.opening();
    const std::size_t after_opening = paper.html.size();
    paper.claims();
    paper.scenes();
    paper.generators();
    paper.table_1();
    paper.pictures();
    paper.shots();
    paper.beyond();
    paper.open_questions();
    paper.html.insert(after_opening, "<nav aria-label=\"Contents\"><ol>" + paper.contents +
                                         "</ol></nav>\n<a class=\"up\" href=\"#\">Contents</a>\n");
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n  <meta charset=\"utf-8\">\n"
           "  <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
           record + "  <title>The multi-path method, reproduced</title>\n  <style>" + style +
           "</style>\n</head>\n<body>\n" + paper.html + "</body>\n</html>\n";
}

} // namespace multipath
