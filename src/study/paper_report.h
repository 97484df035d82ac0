#pragma once

#include "check/scene_report.h"
#include "study/curve.h"
#include "study/report.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

// The paper's reproduction: the commands that compute its tables and figures, what they find, and the report of it.

namespace multipath {

/// One command of the paper's reproduction.
struct PaperStep
{
    std::vector<std::string> words;   ///< of the command, without outputs and what does not change the result
    std::vector<std::string> outputs; ///< names of the files that it makes
};

/// The words as a user would type them, outputs included.
std::string typed(const PaperStep& step);

/// All tables and figures of the paper and what goes beyond it, in the order in which they are made: a later step may
/// read what an earlier one has written into `folder`. `scenes` is the folder of the bundled scenes. The quick set
/// differs in the numbers of lines and executions alone.
std::vector<PaperStep> paper_steps(bool quick, const std::string& scenes, const std::string& folder);

// Numbers printed in the paper (Castro, Martinez, Sbert 1998), to be set beside those that the program finds.

/// A row of Table 1: the slopes of log MSE against log N.
struct PublishedSlope
{
    const char* sequence; ///< as --sequence names it
    double five_cubes;
    double four_chairs;
};

constexpr std::array<PublishedSlope, 3> published_slopes = {
    {{"halton:2,7,3,5", -1.098, -0.998}, {"halton:11,13,17,19", -0.844, -1.113}, {"sobol", -1.102, -1.122}}};

/// Section 4.2: the arguments of (3), and its result.
struct PublishedBudget
{
    double average_reflectance;   ///< R_ave
    double secondary_reflectance; ///< R_s'
    double lit_fraction;          ///< f
    double intersections;         ///< n_int
    double ratio;                 ///< N_l / N_g
};

constexpr PublishedBudget published_up = {0.577, 0.7, 0.073, 2.1, 0.41};       ///< first shot, lit upwards
constexpr PublishedBudget published_down = {0.577, 0.65, 0.67, 2.1, 0.85};     ///< first shot, lit downwards
constexpr PublishedBudget published_extended = {0.577, 0.577, 1.0, 2.1, 1.06}; ///< extended first shot, both

/// The numbers of one scene as the program finds them.
struct SceneFindings
{
    std::string name; ///< "4CHAIRS, lit upwards"
    std::uint32_t patches = 0;
    SceneReport report;
};

/// All results of the reproduction of the paper, for its report.
struct PaperFindings
{
    bool quick = false;
    std::vector<std::string> facts; ///< about the run: version, machine, date, duration
    SceneFindings five_cubes;
    SceneFindings four_chairs;
    SceneFindings four_chairs_up;
    std::map<std::string, Study> studies;        ///< by the name of their files without extension
    std::map<std::string, std::string> commands; ///< that made a file, by its name

    const Study& study(const std::string& name) const { return studies.at(name); }
};

/// The curve of a study with this method and sequence, and this line order if one is given. Throws std::out_of_range.
const Curve& curve_of(const Study& study, const std::string& method, const std::string& sequence,
                      const std::string& line_order = "", const std::string& pairing = "");

/// Judgement of a statement: undecided while the 95 % interval of a number holds values for and against it.
enum class Verdict { holds, undecided, differs };

std::string verdict_word(Verdict verdict);

/// A statement of the paper beside the result.
struct Claim
{
    std::string statement;
    std::string expected;
    std::string found;
    Verdict verdict = Verdict::differs;
    std::string remark; ///< may be empty
};

/// The statements in the order of the paper.
std::vector<Claim> paper_claims(const PaperFindings& findings);

/// The same as lines for a terminal.
std::string claims_text(const std::vector<Claim>& claims);

/// The report of the paper's reproduction: its statements beside what was found, then every table and figure, each with
/// how to read it.
Report paper_report(const PaperFindings& findings);

} // namespace multipath
