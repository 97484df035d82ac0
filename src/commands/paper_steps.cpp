#include "commands/paper_steps.h"

namespace multipath {

namespace {

/// Numbers of lines and executions of the studies, as words for their options.
struct Effort
{
    std::string slopes_from; ///< lines of Table 1 and Figures 3 and 4; line reuse has as many at most
    std::string slopes_to;
    std::string order_to; ///< lines of the study of the order of the lines; its bias shows only with many
    std::string shots_to; ///< lines of Figures 7 to 9, from 46875 on; 46875 * 2^5 = 1.5 million
    std::string reference_lines;
    std::string open_to; ///< lines of the studies of ratio and threshold
    std::string replicates;
};

const Effort full_effort = {"2^15", "2^21", "2^22", "1.5M", "16M", "2^18", "6"};
const Effort quick_effort = {"2^14", "2^19", "2^20", "375k", "2M", "2^17", "3"};

using Steps = std::vector<std::string>;

/// Appends a study with a table and a plot as outputs.
void add_study(Steps& list, const std::string& name, const std::string& words)
{
    list.push_back("study " + words + " -o " + name + ".csv -o " + name + ".svg");
}

/// The patch size that `study` chooses for this scene by default; `solve` would choose adaptive patches.
const std::string patches_of_4chairs = " --patch-size 0.25";

/// Section 3: sequences.
void add_sequences(Steps& list, const Effort& effort)
{
    const std::string few = "halton:2,7,3,5,halton:11,13,17,19,sobol";
    const std::string curves = " --methods first-shot --sequences random," + few + " --line-orders sequence";
    const std::string lines = " --from " + effort.slopes_from + " --to ";
    const std::string replicates = " --replicates " + effort.replicates;
    const std::string slopes = lines + effort.slopes_to + replicates;
    list.push_back("points --figure 1 -o figure1.svg");
    list.push_back("points --figure 2 -o figure2.svg");
    add_study(list, "figure3", "5cubes" + curves + slopes);
    add_study(list, "figure4", "4chairs" + curves + slopes);
    add_study(list, "order",
              "5cubes --patch-size 0.5 --methods first-shot --sequences " + few + " --line-orders sequence,shuffled" +
                  lines + effort.order_to + replicates);
    add_study(list, "pairs", "5cubes --methods first-shot --sequences halton,sobol --pairings 4d,2d" + slopes);
    const std::string picture =
        "solve 4chairs" + patches_of_4chairs + " --method first-shot --line-order sequence --lines ";
    const std::string flat = " --shading flat --size 400x300";
    list.push_back(picture + "266000 --sequence random" + flat + " -o figure5a.png");
    list.push_back(picture + "266000 --sequence halton:11,13,17,19" + flat + " -o figure5b.png");
    list.push_back(picture + "532000 --sequence random" + flat + " -o figure5c.png");
    list.push_back(picture + "532000 --sequence halton:11,13,17,19" + flat + " -o figure5d.png");
}

/// Section 4: the extended first shot. The errors are measured against two references: the best that the program can
/// compute, and one like the paper's.
void add_shots(Steps& list, const Effort& effort)
{
    const auto picture = [&](const std::string& method, const std::string& file) {
        list.push_back("solve 4chairs-up" + patches_of_4chairs + " --method " + method +
                       " --lines 1.5M --sequence random --shading flat --size 400x300 -o " + file);
    };
    picture("first-shot", "figure6a.png");
    picture("extended", "figure6b.png");
    picture("local", "figure6c.png");

    const std::string random =
        " --sequences random --from 46875 --to " + effort.shots_to + " --replicates " + effort.replicates;
    const std::string all = " --methods first-shot,extended,local" + random;
    add_study(list, "figure7", "4chairs-up" + all);
    add_study(list, "figure8", "4chairs-up --methods extended,local" + random);
    add_study(list, "figure9", "4chairs" + all);

    const std::string reference =
        patches_of_4chairs + " --method local --sequence random --replicates 4 --lines " + effort.reference_lines;
    list.push_back("solve 4chairs-up" + reference + " -o reference-up.csv");
    list.push_back("solve 4chairs" + reference + " -o reference-down.csv");
    list.push_back("study 4chairs-up" + all + " --reference FOLDER/reference-up.csv -o figure7-local.csv");
    list.push_back("study 4chairs" + all + " --reference FOLDER/reference-down.csv -o figure9-local.csv");
}

/// Line reuse, which goes beyond the paper, against lines and against seconds: with its table of all pairs, which pays
/// for so many patches from 2^16 lines on.
void add_reuse(Steps& list, const Effort& effort)
{
    const std::string lines =
        " --patches 1000 --from 2^16 --to " + effort.slopes_to + " --replicates " + effort.replicates;
    for (const std::string scene : {"5cubes", "4chairs", "4chairs-up"}) {
        const std::string curves = scene + " --methods extended,reuse --sequences random,sobol-owen";
        add_study(list, "reuse-" + scene, curves + lines);
        list.push_back("study " + curves + " --against seconds" + lines + " -o reuse-" + scene + "-seconds.svg");
    }
}

/// The paper's open questions: whether (3) and (4) are the best ratio and the best threshold.
void add_open_questions(Steps& list, const Effort& effort)
{
    const std::string lines = " --to " + effort.open_to + " --replicates " + effort.replicates;
    const std::string sequences = " --sequences random,sobol";
    for (const std::string scene : {"5cubes", "4chairs", "4chairs-up", "cornell", "studio"})
        add_study(list, "ratio-" + scene,
                  scene + " --methods first-shot,extended" + sequences + " --ratios 1/16..16" + lines);
    for (const std::string scene : {"5cubes", "4chairs", "4chairs-up"})
        add_study(list, "threshold-" + scene,
                  scene + " --methods extended" + sequences + " --thresholds 0,1/16..16 --ratio measured" + lines);
}

} // namespace

std::vector<std::string> paper_steps(bool quick)
{
    const Effort& effort = quick ? quick_effort : full_effort;
    Steps list;
    add_sequences(list, effort);
    add_shots(list, effort);
    add_reuse(list, effort);
    add_open_questions(list, effort);
    return list;
}

} // namespace multipath
