#include "radiosity/scene_lint.h"

#include "scene/coincident_faces.h"
#include "scene/open_edges.h"
#include "scene/text_format.h"

#include <algorithm>
#include <numeric>

namespace multipath {

namespace {

constexpr std::size_t most_named = 4;
constexpr std::size_t most_coincident_pairs = 10000;

class Lint
{
public:
    Lint(const Scene& scene, const SceneReport& report) : scene_(scene), file_(scene.file()), report_(report) {}

    std::vector<Finding> findings()
    {
        idle_emitters();
        lost_behind();
        escaping();
        coincident_faces();
        reader_flaws();
        reflectances();
        scale();
        std::stable_partition(findings_.begin(), findings_.end(),
                              [](const Finding& f) { return f.makes_wrong_result; });
        return std::move(findings_);
    }

private:
    void add(const char* kind, bool wrong, const std::string& place, const std::string& message)
    {
        findings_.push_back({kind, wrong, place, message});
    }

    std::string place_of(std::uint32_t surface) const { return file_.path + ":" + std::to_string(file_.line[surface]); }

    /// "table_top (line 12)"
    std::string name_of(std::uint32_t surface) const
    {
        const std::string& group = file_.groups[file_.group[surface]];
        return (group.empty() ? "a face" : group) + " (line " + std::to_string(file_.line[surface]) + ")";
    }

    /// The surfaces with the largest counts, named with their share of the whole.
    std::string largest(const std::vector<std::uint64_t>& counts) const
    {
        std::vector<std::uint32_t> order(counts.size());
        std::iota(order.begin(), order.end(), 0u);
        const auto shown = std::min(most_named, order.size());
        std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown), order.end(),
                          [&](std::uint32_t a, std::uint32_t b) {
                              return counts[a] > counts[b] || (counts[a] == counts[b] && a < b);
                          });
        const auto whole = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
        std::string text;
        for (std::size_t i = 0; i < shown && counts[order[i]] > 0; ++i)
            text += (i == 0 ? "" : ", ") + name_of(order[i]) +
                    format(" %.0f %%", 100.0 * static_cast<double>(counts[order[i]]) / whole);
        return text;
    }

    std::uint32_t first_of(const std::vector<std::uint64_t>& counts) const
    {
        return static_cast<std::uint32_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
    }

    double share(Rgb part) const { return mean(part) / mean(report_.balance.emitted); }

    void idle_emitters()
    {
        for (std::uint32_t s = 0; s < file_.surfaces.size(); ++s)
            if (mean(file_.materials[file_.material[s]].emittance) > 0.0 && report_.survey.departures[s] > 0 &&
                report_.survey.arrivals[s] == 0)
                add("emitter", true, place_of(s),
                    "the emitter " + name_of(s) +
                        " lights nothing: it faces away from everything; reverse the order of its corners");
    }

    void lost_behind()
    {
        const double lost = share(report_.balance.behind);
        if (!(lost > 1e-9))
            return;
        add("behind", true, place_of(first_of(report_.survey.met_behind)),
            format("%.3g %% of the power meets surfaces from behind and is lost: ", 100.0 * lost) +
                largest(report_.survey.met_behind) +
                "; reverse these faces if they look the wrong way, close the solids that they belong to (a box on the "
                "floor needs its bottom, a lamp its back), or use --two-sided");
    }

    void escaping()
    {
        const double lost = share(report_.balance.escaped);
        if (!(lost > 1e-9))
            return;
        const std::vector<std::uint32_t> open = surfaces_with_open_edges(scene_.surfaces());
        std::string edges;
        for (std::size_t i = 0; i < std::min(most_named, open.size()); ++i)
            edges += (i == 0 ? "; open edges: " : ", ") + name_of(open[i]);
        if (open.size() > most_named)
            edges += format(" and %zu more", open.size() - most_named);
        const bool leak = lost < 0.01;
        add(leak ? "leak" : "open", leak, open.empty() ? file_.path : place_of(open[0]),
            format("%.3g %% of the power escapes", 100.0 * lost) +
                (leak ? ": the scene looks closed but leaks; close the gaps" : ": the scene is open") + edges);
    }

    void coincident_faces()
    {
        const std::vector<CoincidentFaces> pairs = find_coincident_faces(scene_, most_coincident_pairs);
        for (const bool same_side : {true, false}) {
            const auto wanted = [&](const CoincidentFaces& pair) { return pair.same_side == same_side; };
            const auto first = std::find_if(pairs.begin(), pairs.end(), wanted);
            if (first == pairs.end())
                continue;
            const auto count = std::count_if(pairs.begin(), pairs.end(), wanted);
            const std::string example = name_of(first->first) + " and " + name_of(first->second);
            if (same_side)
                add("duplicate", true, place_of(first->second),
                    format("%td pair%s of faces lie in one place and face the same way, so the smaller hides the "
                           "larger where they overlap: ",
                           count, count == 1 ? "" : "s") +
                        example + "; remove one or move it");
            else
                add("coincident", false, place_of(first->second),
                    format("%td pair%s of faces touch with their fronts or backs, which is handled: ", count,
                           count == 1 ? "" : "s") +
                        example);
        }
    }

    void reader_flaws()
    {
        for (const std::string& name : file_.unknown_materials)
            add("unknown-material", true, file_.path,
                "material '" + name + "' is not defined, grey 0.5 stands in; define it in the MTL file");
        for (const std::string& unused : file_.unused_materials) {
            const std::size_t colon = unused.rfind(": ");
            add("unused-material", false, unused.substr(0, colon),
                "material '" + unused.substr(colon + 2) + "' is used by no face");
        }
        if (file_.dropped_faces > 0)
            add("zero-area", false, file_.path,
                std::to_string(file_.dropped_faces) + " faces without an area were dropped");
        for (const std::string& warning : file_.warnings) {
            const std::size_t colon = warning.find(": ");
            add("reader", false, warning.substr(0, colon),
                colon == std::string::npos ? warning : warning.substr(colon + 2));
        }
    }

    void reflectances()
    {
        for (const Material& material : file_.materials) {
            const Rgb rho = material.reflectance;
            if (std::max({rho.r, rho.g, rho.b}) >= 0.95)
                add("reflectance", false, material.source,
                    "material '" + material.name +
                        format("' reflects %.0f %% of the light, more than any paint",
                               100.0 * std::max({rho.r, rho.g, rho.b})) +
                        "; multiplied over many reflections this decides the brightness, so lower Kd if it is not "
                        "meant");
        }
    }

    void scale()
    {
        const double diagonal = scene_.bounds().diagonal();
        if (diagonal < 0.1 || diagonal > 500.0)
            add("scale", false, file_.path,
                format("the scene measures %.3g m across if its unit is the metre; the radiosity does not depend on "
                       "it, but powers in "
                       "watts do",
                       diagonal));
    }

    const Scene& scene_;
    const SceneFile& file_;
    const SceneReport& report_;
    std::vector<Finding> findings_;
};

} // namespace

std::vector<Finding> lint(const Scene& scene, const SceneReport& report)
{
    return Lint(scene, report).findings();
}

} // namespace multipath
