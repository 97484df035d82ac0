#pragma once

#include "check/scene_report.h"
#include "study/curve.h"
#include "study/report.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

// The reproduction of the paper: the commands that compute its tables and figures, their results, and the report.

namespace multipath {

/// One command of the reproduction.
struct PaperStep
{
    std::vector<std::string> words;   ///< of the command, without outputs and options that do not change the result
    std::vector<std::string> outputs; ///< names of the files that it makes
};

/// The command line as a user would type it, outputs included.
std::string typed(const PaperStep& step);

/// The commands for all tables and figures of the paper, and for the results beyond it, in the order in which they are
/// run: a later step may read what an earlier one has written into `folder`. `scenes` is the folder of the bundled
/// scenes. The quick set differs only in the numbers of lines and executions.
std::vector<PaperStep> paper_steps(bool quick, const std::string& scenes, const std::string& folder);

// Numbers printed in the paper (Castro, Martinez, Sbert 1998), for comparison with those of the program.

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

/// The figures that the program measures for one scene.
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
    std::map<std::string, Study> studies;        ///< by file name without extension
    std::map<std::string, std::string> commands; ///< the command that made a file, by the name of the file

    const Study& study(const std::string& name) const { return studies.at(name); }
};

/// The first curve of a study with this method and sequence, and with this line order and pairing unless they are
/// empty. Throws std::out_of_range if there is none.
const Curve& curve_of(const Study& study, const std::string& method, const std::string& sequence,
                      const std::string& line_order = "", const std::string& pairing = "");

/// Verdict on a statement. It is undecided if the 95 % interval of the measured number contains values for and against
/// it.
enum class Verdict { holds, undecided, differs };

std::string verdict_word(Verdict verdict);

/// A statement of the paper and the result for it.
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

/// The report of the reproduction: the statements of the paper beside the results, then every table and figure with an
/// explanation.
Report paper_report(const PaperFindings& findings);

} // namespace multipath
