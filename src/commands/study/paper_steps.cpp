#include "commands/study/paper_steps.h"

#include <initializer_list>
#include <sstream>

namespace multipath {

namespace {

/// How much work to spend.
struct Effort
{
    const char* slopes_from; ///< lines of Table 1 and Figures 3 and 4
    const char* slopes_to;
    const char* order_to; ///< lines of the experiment with the order of the lines, whose bias shows late
    const char* shots_to; ///< lines of Figures 7 to 9, from 46875 on; 46875 * 2^5 = 1.5 million
    const char* reference_lines;
    const char* replicates;
};

constexpr Effort full_effort = {"2^15", "2^21", "2^22", "1.5M", "16M", "6"};
constexpr Effort quick_effort = {"2^14", "2^19", "2^20", "375k", "2M", "3"};

std::vector<std::string> words_of(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

/// The words of one command in a text with blanks between them, `scenes` and other folders apart, which may hold
/// blanks.
class StepList
{
public:
    StepList(std::string scenes, const Effort& effort) : scenes_(std::move(scenes)), effort_(effort) {}

    void add(const std::string& command, const std::string& scene, const std::string& options,
             const std::vector<std::string>& outputs, const std::vector<std::string>& more = {})
    {
        PaperStep step;
        step.words.push_back(command);
        if (!scene.empty())
            step.words.push_back(scenes_ + "/" + scene);
        for (const std::string& word : words_of(options))
            step.words.push_back(word);
        step.words.insert(step.words.end(), more.begin(), more.end());
        step.outputs = outputs;
        steps.push_back(step);
    }
    void study(const std::string& name, const std::string& scene, const std::string& options,
               const std::vector<std::string>& more = {})
    {
        add("study", scene, options + " --replicates " + effort_.replicates, {name + ".csv", name + ".svg"}, more);
    }
    void slopes(const std::string& name, const std::string& scene, const std::string& options)
    {
        study(name, scene, options + " --from " + effort_.slopes_from + " --to " + effort_.slopes_to);
    }
    void order(const std::string& name, const std::string& scene, const std::string& options)
    {
        study(name, scene, options + " --from " + effort_.slopes_from + " --to " + effort_.order_to);
    }
    void shots(const std::string& name, const std::string& scene, const std::string& methods,
               const std::vector<std::string>& more = {})
    {
        study(name, scene,
              "--methods " + methods + " --sequences random --from 46875 --to " + std::string(effort_.shots_to), more);
    }

    /// The same as a table alone.
    void shots_table(const std::string& name, const std::string& scene, const std::vector<std::string>& more)
    {
        shots(name, scene, "first-shot,extended,local", more);
        steps.back().outputs = {name + ".csv"};
    }

    std::vector<PaperStep> steps;

private:
    std::string scenes_;
    const Effort& effort_;
};

/// Section 3: sequences.
void add_sequences(StepList& list)
{
    const std::string curves =
        "--methods first-shot --sequences random,halton:2,7,3,5,halton:11,13,17,19,sobol --line-orders sequence";
    list.add("points", "", "--figure 1", {"figure1.svg"});
    list.add("points", "", "--figure 2", {"figure2.svg"});
    list.slopes("figure3", "5cubes.obj", curves);
    list.slopes("figure4", "4chairs.obj", curves);
    list.order("order", "5cubes.obj",
               "--patch-size 0.5 --methods first-shot --sequences halton:2,7,3,5,halton:11,13,17,19,sobol "
               "--line-orders sequence,shuffled");
    list.slopes("pairs", "5cubes.obj", "--methods first-shot --sequences halton,sobol --pairings 4d,2d");
    const char* letters[] = {"a", "b", "c", "d"};
    for (int k = 0; k < 4; ++k)
        list.add("solve", "4chairs.obj",
                 std::string("--method first-shot --line-order sequence --lines ") + (k < 2 ? "266000" : "532000") +
                     " --sequence " + (k % 2 == 0 ? "random" : "halton:11,13,17,19") + " --shading flat --size 400x300",
                 {std::string("figure5") + letters[k] + ".png"});
}

/// Section 4: the extended first shot. Every plot is made against two references: as good a one as the program can
/// make, and one like the paper's.
void add_shots(StepList& list, const std::string& reference_lines, const std::string& folder)
{
    const char* methods[] = {"first-shot", "extended", "local"};
    const char* letters[] = {"a", "b", "c"};
    for (int k = 0; k < 3; ++k)
        list.add("solve", "4chairs-up.obj",
                 std::string("--method ") + methods[k] +
                     " --lines 1.5M --sequence random --shading flat --size 400x300",
                 {std::string("figure6") + letters[k] + ".png"});
    list.shots("figure7", "4chairs-up.obj", "first-shot,extended,local");
    list.shots("figure8", "4chairs-up.obj", "extended,local");
    list.shots("figure9", "4chairs.obj", "first-shot,extended,local");
    const std::string reference = "--method local --sequence random --replicates 4 --lines " + reference_lines;
    list.add("solve", "4chairs-up.obj", reference, {"reference-up.csv"});
    list.add("solve", "4chairs.obj", reference, {"reference-down.csv"});
    list.shots_table("figure7-local", "4chairs-up.obj", {"--reference", folder + "/reference-up.csv"});
    list.shots_table("figure9-local", "4chairs.obj", {"--reference", folder + "/reference-down.csv"});
    list.shots_table("figure9-coarse", "4chairs.obj", {"--patch-size", "0.5"});
    list.shots_table("figure9-fine", "4chairs.obj", {"--patch-size", "0.15"});
}

/// Line reuse, which goes beyond the paper, against lines and against seconds.
void add_reuse(StepList& list)
{
    for (const std::string scene : {"5cubes", "4chairs", "4chairs-up"}) {
        const std::string curves = "--methods extended,reuse --sequences random,sobol-owen";
        list.slopes("reuse-" + scene, scene + ".obj", curves);
        list.slopes("reuse-" + scene + "-seconds", scene + ".obj", curves + " --against seconds");
        list.steps.back().outputs = {"reuse-" + scene + "-seconds.svg"}; // the table is that of the step before
    }
}

} // namespace

std::string typed(const PaperStep& step)
{
    std::string text = "multipath";
    for (const std::string& word : step.words)
        text += " " + word;
    for (const std::string& output : step.outputs)
        text += " -o " + output;
    return text;
}

std::vector<PaperStep> paper_steps(bool quick, const std::string& scenes, const std::string& folder)
{
    const Effort& effort = quick ? quick_effort : full_effort;
    StepList list(scenes, effort);
    add_sequences(list);
    add_shots(list, effort.reference_lines, folder);
    add_reuse(list);
    return list.steps;
}

} // namespace multipath
