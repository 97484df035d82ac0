#include "cli/number_text.h"
#include "cli/standard_streams.h"
#include "commands/commands.h"
#include "commands/comparison_report.h"
#include "commands/result_table.h"
#include "export/comments.h"
#include "scene/text_format.h"

#include <optional>

namespace multipath {

namespace {

CommandTable compare_table()
{
    return {"compare",
            "how far one result is from another of the same scene",
            {{"A", false, false, {".csv", ".state"}}, {"B", false, false, {".csv", ".state"}}},
            {{"Report",
              {{"worst", 0, "N", "5", "Name the N patches with the largest shares of the mean square error."},
               {"tolerance", 0, "SHARE", "",
                "End with exit code 1 when the root of the relative mean square error exceeds this, such as 1%."},
               {"json", 0, "", "", "Print the report as JSON on standard output."}}}},
            "A is measured against B, the reference. Both are tables that 'multipath solve -o FILE.csv'\n"
            "wrote, or states of finished runs, of the same patches. Where they have standard errors\n"
            "(solve --replicates), the report tells whether these explain the difference.\n\n"
            "Exit code 0, whatever the difference, unless --tolerance says otherwise; 1 where the tables\n"
            "cannot be compared.\n"};
}

void warn_of_other_scene(const PatchTable& a, const PatchTable& b)
{
    const std::optional<std::string> scene_a = comment_value(a.comments, "scene");
    const std::optional<std::string> scene_b = comment_value(b.comments, "scene");
    if (scene_a && scene_b && *scene_a != *scene_b)
        print_note(format("warning: %s is of scene %s and %s of scene %s, though their patches have the same areas\n",
                          a.path.c_str(), scene_a->c_str(), b.path.c_str(), scene_b->c_str()));
}

int run_compare(const CommandLine& line)
{
    const auto worst_count = static_cast<std::size_t>(read_count("--worst", line.text("worst")));
    std::optional<double> tolerance;
    if (line.has("tolerance"))
        tolerance = read_share("--tolerance", line.text("tolerance"));
    const PatchTable a = read_result(line.operands()[0]);
    const PatchTable b = read_result(line.operands()[1]);
    require_same_patches(a, b);
    warn_of_other_scene(a, b);
    const Comparison comparison = compare(a, b, worst_count);
    const std::string text = line.has("json") ? report_json(comparison).document() : report_text(comparison);
    print(text);
    if (!tolerance || comparison.root() <= *tolerance)
        return 0;
    print_note(format("multipath: %s is %.4g %% from %s, expected at most %.4g %%\n", a.path.c_str(),
                      100.0 * comparison.root(), b.path.c_str(), 100.0 * *tolerance));
    return 1;
}

} // namespace

Command compare_command()
{
    return {compare_table(), run_compare};
}

} // namespace multipath
