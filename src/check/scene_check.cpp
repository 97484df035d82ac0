#include "check/scene_check.h"

#include "base/lists.h"
#include "base/text_format.h"
#include "geometry/intersector/intersector.h"
#include "geometry/intersector/surface_sizes.h"
#include "scene/surface_edges.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

namespace multipath {

// Coincident faces are searched for at sample points of each surface: a point that lies on another surface, too, shows
// an overlap.

namespace {

/// Sample points inside a surface: 16 find an overlap of a tenth of its area unless it is narrow. A single one in a
/// scene of more than 100,000 surfaces.
std::vector<Vec3> sample_points(const Surface& surface, std::size_t surface_count)
{
    const int n = surface_count > 100000 ? 1 : 4;
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double u = (i + 0.5) / n;
            const double v = (j + 0.5) / n;
            const bool folded = surface.shape == Shape::triangle && u + v >= 1.0;
            points.push_back(folded ? surface.at(0.9 * (1.0 - u) + 0.03, 0.9 * (1.0 - v) + 0.03) : surface.at(u, v));
        }
    return points;
}

/// Returns k if every k-th surface is to be searched. k is 1 unless the sample points lie in the boxes of so many other
/// surfaces, such as slivers with a common corner, that a complete search would take minutes.
std::size_t surfaces_per_search(const Scene& scene)
{
    constexpr std::size_t trials = 64;
    constexpr double bearable = 1u << 28; // surfaces tested; about a second
    const SurfaceList& surfaces = scene.surfaces();
    double looked_at = 0.0;
    for (std::size_t k = 0; k < trials; ++k) {
        const auto s = static_cast<std::uint32_t>(k * surfaces.size() / trials);
        for (const Vec3 point : sample_points(surfaces[s], surfaces.size()))
            looked_at += static_cast<double>(scene.intersector().surfaces_around(s, point));
    }
    return static_cast<std::size_t>(1.0 + looked_at / trials * static_cast<double>(surfaces.size()) / bearable);
}

} // namespace

CoincidentPairs find_coincident_faces(const Scene& scene, std::size_t most)
{
    CoincidentPairs result;
    std::set<std::pair<std::uint32_t, std::uint32_t>>& pairs = result.pairs;
    const SurfaceList& surfaces = scene.surfaces();
    const std::size_t step = surfaces_per_search(scene);
    result.complete = step == 1;
    for (std::size_t k = 0; k < surfaces.size(); k += step) {
        const auto s = static_cast<std::uint32_t>(k);
        for (const Vec3 point : sample_points(surfaces[s], surfaces.size()))
            for (const std::uint32_t other : scene.intersector().coincident_surfaces(s, point)) {
                if (!(dot(surfaces[s].normal(), surfaces[other].normal()) > 0.0))
                    continue;
                if (pairs.size() < most)
                    pairs.insert(std::minmax(s, other));
                else
                    result.complete = result.complete && pairs.count(std::minmax(s, other)) > 0;
            }
        if (!result.complete && pairs.size() >= most)
            break;
    }
    return result;
}

std::vector<std::uint32_t> surfaces_with_open_edges(const SurfaceList& surfaces)
{
    std::set<std::uint32_t> open;
    for_each_edge(edges_of(surfaces, bounds_of(surfaces)), [&](auto begin, auto end) {
        if (std::all_of(begin, end, [&](const FaceEdge& side) { return side.upward == begin->upward; }))
            std::for_each(begin, end, [&](const FaceEdge& side) { open.insert(side.face); });
    });
    return {open.begin(), open.end()};
}

// The checks look at the scene, at the file from which it was read, and at the survey of lines and the power balance in
// the SceneReport. Each check appends its findings, which are sorted at the end.

namespace {

constexpr std::size_t most_names = 4; ///< names in a list
constexpr std::size_t most_coincident_pairs = 10000;
/// Least share [1] of the power of the sources, or of the area of the surfaces, at which a finding is an error: the
/// fault makes the result wrong. A fault with a smaller share changes the result by less than one step of an 8-bit
/// picture, and by less than the noise of most runs.
constexpr double share_that_matters = 0.005;
constexpr double least_reported = 1e-5; ///< [1] share of the power; smaller losses are not reported
/// Kinds of findings that are remarks whatever their share.
constexpr std::array<std::string_view, 2> remarks = {"open", "reflectance"};

bool emits(const Scene& scene, std::uint32_t surface)
{
    return mean(scene.surface_material(surface).emittance) > 0.0;
}

/// "'a', 'b' and 7 more"
std::string list_of(std::vector<std::string> names)
{
    for (std::string& name : names)
        name = "'" + name + "'";
    return first_of(names, most_names);
}

/// Runs all checks of a scene, each of which appends its findings.
class SceneChecks
{
public:
    SceneChecks(const Scene& scene, const SceneReport& report)
        : scene_(scene), file_(scene.file()), survey_(report.survey), report_(report)
    {
    }

    std::vector<Finding> findings()
    {
        trapped_light();
        idle_emitters();
        lost_behind();
        escaping();
        coincident_faces();
        unknown_materials();
        bright_materials();
        reader_flaws();
        scale();
        for (Finding& finding : findings_)
            finding.makes_wrong_result = std::max(finding.power_share, finding.area_share) >= share_that_matters &&
                                         !is_among(finding.kind, remarks);
        std::stable_sort(findings_.begin(), findings_.end(), [](const Finding& a, const Finding& b) {
            return std::tie(a.makes_wrong_result, a.power_share, a.area_share) >
                   std::tie(b.makes_wrong_result, b.power_share, b.area_share);
        });
        return std::move(findings_);
    }

private:
    void add(const char* kind, const std::string& place, const std::string& message, double power_share = 0.0,
             double area_share = 0.0, const std::vector<Advice>& advice = {})
    {
        findings_.push_back({kind, place, message, power_share, area_share, advice});
    }

    std::string place_of(std::uint32_t surface) const { return file_.path + ":" + std::to_string(file_.line[surface]); }

    /// "table_top (line 12)", or "table_top of table (line 12)" if objects are divided into groups
    std::string name_of(std::uint32_t surface) const
    {
        const std::string& group = file_.groups[file_.group[surface]];
        const std::string other = file_.other_name(surface);
        return (group.empty() ? "a face" : group) + (other.empty() ? "" : " of " + other) + " (line " +
               std::to_string(file_.line[surface]) + ")";
    }

    /// The first surfaces by name.
    std::string names_of(const std::vector<std::uint32_t>& surfaces) const
    {
        return first_of(mapped(surfaces, [this](std::uint32_t s) { return name_of(s); }), most_names);
    }

    /// The surfaces that lines meet from behind, those that most lines meet first.
    std::vector<std::uint32_t> met_behind() const
    {
        const std::vector<std::uint64_t>& counts = survey_.met_behind;
        std::vector<std::uint32_t> order;
        for (std::uint32_t s = 0; s < counts.size(); ++s)
            if (counts[s] > 0)
                order.push_back(s);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return counts[a] > counts[b]; });
        return order;
    }

    double share(Rgb part) const { return report_.trapped ? 0.0 : mean(part) / mean(report_.balance.emitted); }
    double area(std::uint32_t surface) const { return scene_.surfaces()[surface].area(); }
    double power(std::uint32_t surface) const
    {
        return area(surface) * mean(scene_.surface_material(surface).emittance);
    }
    double area_of_surfaces() const { return scene_.own_area() / (scene_.two_sided() ? 2.0 : 1.0); }

    void trapped_light()
    {
        if (!report_.trapped)
            return;
        add("trapped", place_of(scene_.surface_of(*report_.trapped)),
            "light is trapped among surfaces that reflect all of it: it has no bound, and `solve` refuses the scene; "
            "lower Kd of '" +
                scene_.material_of(*report_.trapped).name + "'",
            1.0);
    }

    /// Of rays from the front of a surface; the lines of the survey may have met it by chance a few times only.
    bool no_ray_arrives(std::uint32_t surface) const
    {
        RayBlock rays;
        rays.items.resize(256);
        make_sequence("random", 1)->generate(0, rays.items);
        rays.patches.assign(rays.items.size(), scene_.first_patch(surface));
        rays.trace(scene_);
        return std::none_of(rays.receivers.begin(), rays.receivers.end(), Segment::is_patch);
    }

    void idle_emitters()
    {
        std::vector<std::uint32_t> idle;
        double idle_power = 0.0;
        bool any_lights = false;
        for (std::uint32_t s = 0; s < file_.surfaces.size(); ++s) {
            if (!emits(scene_, s))
                continue;
            any_lights = any_lights || survey_.arrivals[s] > 0;
            if (survey_.departures[s] > 0 && survey_.arrivals[s] == 0 && no_ray_arrives(s)) {
                idle.push_back(s);
                idle_power += power(s);
            }
        }
        if (idle.empty())
            return;
        const double part = idle_power / mean(scene_.source_power());
        std::vector<Advice> advice;
        if (!any_lights && !file_.is_flipped && idle.size() < scene_.own_surfaces())
            advice = {{Remedy::flip, "", "turns all faces over, if the scene is inside out"}};
        add("emitter", place_of(idle[0]),
            format("emitters that light nothing, facing away from everything (%.3g %% of the source power): ",
                   100.0 * part) +
                names_of(idle) + "; reverse the order of their corners",
            part, 0.0, advice);
    }

    void lost_behind()
    {
        const double lost = share(report_.balance.behind);
        if (file_.sky_surfaces > 0 || !(lost > least_reported))
            return;
        const std::vector<std::uint32_t> surfaces = met_behind();
        const std::string text = format("%.3g %% of the power meets surfaces from behind and is lost", 100.0 * lost) +
                                 (surfaces.empty() ? "" : ": " + names_of(surfaces));
        const bool matters = lost >= share_that_matters;
        std::vector<Advice> advice;
        if (matters)
            advice = {{Remedy::two_sided, "", "gives every face a back"}};
        add("behind", surfaces.empty() ? file_.path : place_of(surfaces[0]),
            text + (matters ? "; reverse these faces if they look the wrong way, or close the solids that they belong "
                              "to (a box on the floor needs its bottom, a lamp its back)"
                            : ", too little to matter"),
            lost, 0.0, advice);
    }

    void escaping()
    {
        const double lost = share(report_.balance.escaped);
        if (file_.sky_surfaces > 0 || !(lost > least_reported))
            return;
        const std::vector<std::uint32_t> open = surfaces_with_open_edges(scene_.surfaces());
        const bool is_open = lost >= 0.01;
        const std::string text = format("%.3g %% of the power escapes", 100.0 * lost) +
                                 (is_open                      ? ": the scene is open"
                                  : lost >= share_that_matters ? ": the scene looks closed but leaks; close the gaps"
                                                               : " through gaps, too little to matter") +
                                 (open.empty() ? "" : "; open edges: " + names_of(open));
        add(is_open ? "open" : "leak", open.empty() ? file_.path : place_of(open[0]), text, lost);
    }

    /// True if two surfaces have the same bounds and centre, as those of equal corners in another order have, and the
    /// same material, which emits nothing.
    bool are_equal(std::uint32_t first, std::uint32_t second) const
    {
        if (file_.material[first] != file_.material[second] || emits(scene_, first))
            return false;
        const Surface& a = scene_.surfaces()[first];
        const Surface& b = scene_.surfaces()[second];
        const Bounds box_a = a.bounds();
        const Bounds box_b = b.bounds();
        const double tolerance = 1e-6 * box_a.diagonal();
        const auto near = [&](Vec3 p, Vec3 q) { return length(p - q) <= tolerance; };
        return near(box_a.low, box_b.low) && near(box_a.high, box_b.high) && near(a.centre(), b.centre());
    }

    void coincident_faces()
    {
        const CoincidentPairs found = find_coincident_faces(scene_, most_coincident_pairs);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> hiding, equal;
        for (const auto& [first, second] : found.pairs)
            (are_equal(first, second) ? equal : hiding).emplace_back(first, second);
        // Upper bounds of the hidden area and power: those of the smaller surface of each pair, each counted once.
        std::set<std::uint32_t> hidden;
        double hidden_area = 0.0, hidden_power = 0.0;
        for (const auto& [first, second] : hiding) {
            const std::uint32_t smaller = area(second) < area(first) ? second : first;
            if (hidden.insert(smaller).second) {
                hidden_area += area(smaller);
                hidden_power += power(smaller);
            }
        }
        const auto add_pairs = [&](const char* kind, const auto& pairs, const std::string& what,
                                   double power_share = 0.0, double area_share = 0.0) {
            if (!pairs.empty())
                add(kind, place_of(pairs[0].second),
                    (found.complete ? "" : "at least ") + counted(pairs.size(), "pair") + " of faces " + what + ": " +
                        name_of(pairs[0].first) + " and " + name_of(pairs[0].second),
                    power_share, area_share);
        };
        add_pairs("duplicate", hiding,
                  "lie in one place and face the same way, so the smaller hides the larger where they overlap; remove "
                  "one or move it",
                  hidden_power / mean(scene_.source_power()), hidden_area / area_of_surfaces());
        add_pairs("copy", equal, "are the same twice, of which one counts");
    }

    /// Adds a finding about the materials that satisfy a condition, with their share of the area.
    template <class Condition>
    void add_materials(const char* kind, const Condition& condition, const std::string& flaw, const std::string& advice)
    {
        std::vector<double> areas(file_.materials.size()); // [m^2]
        for (std::uint32_t s = 0; s < file_.surfaces.size(); ++s)
            areas[file_.material[s]] += area(s);
        std::vector<std::string> names;
        std::string place;
        double all = 0.0;
        for (std::size_t m = 0; m < areas.size(); ++m) {
            const Material& material = file_.materials[m];
            if (!condition(material))
                continue;
            place = names.empty() ? material.source : place;
            names.push_back(material.name);
            all += areas[m];
        }
        if (!names.empty())
            add(kind, place, flaw + list_of(names) + advice, 0.0, all / area_of_surfaces());
    }

    void unknown_materials()
    {
        add_materials(
            "unknown-material", [this](const Material& m) { return is_among(m.name, file_.unknown_materials); },
            "materials that are not defined, grey 0.5 stands in: ", "; define them in an MTL file");
    }

    void bright_materials()
    {
        const auto brightness = [](const Material& m) {
            return std::max({m.reflectance.r, m.reflectance.g, m.reflectance.b});
        };
        double brightest = 0.0;
        for (const Material& m : file_.materials)
            brightest = std::max(brightest, brightness(m));
        add_materials(
            "reflectance", [&](const Material& m) { return brightness(m) >= 0.95; },
            format("materials that reflect up to %.0f %% of the light, more than any paint: ", 100.0 * brightest),
            "; multiplied over many reflections this decides the brightness, so lower Kd if it is not meant");
    }

    void reader_flaws()
    {
        std::vector<std::string> names;
        for (const std::string& unused : file_.unused_materials)
            names.push_back(unused.substr(unused.rfind(": ") + 2));
        if (!names.empty())
            add("unused-material", file_.unused_materials[0].substr(0, file_.unused_materials[0].rfind(": ")),
                "materials that no face uses: " + list_of(names));
        for (const std::string& warning : file_.warnings) {
            const std::size_t colon = warning.find(": ");
            add("reader", warning.substr(0, colon), warning.substr(colon == std::string::npos ? 0 : colon + 2));
        }
    }

    void scale()
    {
        const double diagonal = scene_.own_bounds().diagonal();
        if (diagonal < 0.1 || diagonal > 500.0)
            add("scale", file_.path,
                format(
                    "the scene measures %.3g m across if its unit is the metre; the radiosity does not depend on it, "
                    "but powers in watts do",
                    diagonal));
    }

    const Scene& scene_;
    const SceneFile& file_;
    const LineSurvey& survey_;
    const SceneReport& report_;
    std::vector<Finding> findings_;
};

} // namespace

std::vector<Finding> findings_of(const Scene& scene, const SceneReport& report)
{
    return SceneChecks(scene, report).findings();
}

} // namespace multipath
