#pragma once

// The reproduction of the paper (Castro, Martinez, Sbert 1998): the results of the commands that compute its tables and
// figures (commands/paper_steps.h), and the report.

#include "check/scene_report.h"
#include "study/curve.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace multipath {

// Numbers printed in the paper, for comparison with those of the program.

/// A row of Table 1: the slopes of log MSE against log N.
struct PublishedSlope
{
    const char* sequence; ///< as --sequence names it
    double five_cubes;    ///< slope for the scene 5CUBES
    double four_chairs;   ///< slope for the scene 4CHAIRS
};

constexpr std::array<PublishedSlope, 3> published_slopes = {
    {{"halton:2,7,3,5", -1.098, -0.998}, {"halton:11,13,17,19", -0.844, -1.113}, {"sobol", -1.102, -1.122}}};

/// Section 4.2: the arguments and the result of formula (3), the ratio of local to global lines (docs/equations.md).
struct PublishedBudget
{
    BudgetFigures figures;
    double ratio; ///< [1] N_l / N_g
};

constexpr PublishedBudget published_up = {{2.1, 0.577, 0.7, 0.073}, 0.41};       ///< first shot, lamp shines upwards
constexpr PublishedBudget published_down = {{2.1, 0.577, 0.65, 0.67}, 0.85};     ///< first shot, lamp shines downwards
constexpr PublishedBudget published_extended = {{2.1, 0.577, 0.577, 1.0}, 1.06}; ///< extended first shot, up or down

/// The numbers that the program measures for one scene.
struct SceneFindings
{
    std::string name;          ///< such as "4CHAIRS, lit upwards"
    std::uint32_t patches = 0; ///< number of patches
    SceneReport report;
};

/// All results of the reproduction, from which the report is written.
struct PaperFindings
{
    SceneFindings five_cubes;
    SceneFindings four_chairs;                   ///< lit downwards
    SceneFindings four_chairs_up;                ///< lit upwards
    std::map<std::string, Study> studies;        ///< by the names of their files without extension
    std::map<std::string, std::string> commands; ///< command line that made a file, by the name of the file

    /// The study with this name. Throws std::out_of_range if there is none.
    const Study& study(const std::string& name) const { return studies.at(name); }
};

/// The first curve of a study with this method and sequence; also with this line order and this pairing, where they are
/// not empty. Throws std::out_of_range if there is none.
const Curve& curve_of(const Study& study, const std::string& method, const std::string& sequence,
                      const std::string& line_order = "", const std::string& pairing = "");

/// Verdict on a statement, from agreement to contradiction. It is undecided if the 95 % interval of the measured number
/// contains values that agree with the statement and values that contradict it. The worse of two is the larger.
enum class Verdict { holds, undecided, differs };

/// A statement, and the result of the program for it.
struct Claim
{
    std::string statement;
    std::string expected; ///< what the paper reports, or what the result is compared with
    std::string found;    ///< what the program measured
    Verdict verdict = Verdict::differs;
};

/// Judges the statements of the paper, in the order of the paper. Throws std::out_of_range if a study or curve is
/// missing, and std::bad_optional_access if a scene has no ratio (3).
std::vector<Claim> paper_claims(const PaperFindings& findings);

/// Judges whether the rule ("auto": (3), "measured": a pilot) leaves at most 3 % more than the least error, for each
/// curve of the studies ratio-SCENE, which vary the ratio. Throws std::out_of_range if a study is missing.
std::vector<Claim> ratio_claims(const PaperFindings& findings, const std::string& rule);

/// Judges for each study threshold-SCENE whether the threshold of (4) is better than none, and than one of 16 times
/// (4).
std::vector<Claim> threshold_claims(const PaperFindings& findings);

/// The scenes of the studies beyond the paper's: names of their files and titles.
constexpr std::array<std::array<const char*, 2>, 5> report_scenes = {{{"5cubes", "5CUBES"},
                                                                      {"4chairs", "4CHAIRS, downwards"},
                                                                      {"4chairs-up", "4CHAIRS, upwards"},
                                                                      {"cornell", "Cornell box"},
                                                                      {"studio", "Attic room, 12,961 faces"}}};

/// The report of the reproduction as a self-contained HTML page: the statements of the paper beside the results, then
/// every table and figure with an explanation. `folder` is the folder that holds the files of the figures. The comments
/// go into the head of the page. Throws like paper_claims(), std::out_of_range if the command of a figure is missing,
/// and InputError if the file of a figure cannot be read.
std::string paper_report(const PaperFindings& findings, const std::string& folder,
                         const std::vector<std::string>& comments);

} // namespace multipath
