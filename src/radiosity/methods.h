#pragma once

#include "transport/lines/global_lines.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace multipath {

class Run;
class Scene;
struct Preparation;
struct SolveOptions;

/// A part of a run that can be interrupted and resumed. Moves the run's state forward.
using Stage = void (*)(Run&);

/// How the results of shards, and of stretches of lines, become one: each is a solution, and they are averaged by their
/// lines; or each is a set of counts, which are added up before the light is solved for.
enum class Shards { averaged, added };

/// Rays from patches that stand out before all other lines: none, those of the sources (S1), or passes of them (S2).
enum class FirstShot { none, plain, extended };

/// A method: one row of the table in methods.cpp. A new method is the file of its stages and a row; command line, help,
/// study, selftest, page and tests iterate over the table.
struct MethodInfo
{
    std::string_view name;
    std::string_view summary; ///< sentences
    /// Options of the command line that do not serve all methods, but this one. "steps:direct=shoot": only with this
    /// value of another option.
    std::string_view options;
    Chords chords; ///< from which global lines are drawn unless the user says otherwise
    Shards shards;
    std::uint64_t most_lines;                       ///< of one run
    std::uint64_t (*lines_per_patch)(const Scene&); ///< of each replicate, before their scatter tells the error
    std::vector<Stage> (*stages)(const Run&);
    void (*prepare)(const Scene&, const SolveOptions&, Preparation&) = nullptr; ///< may be null
    FirstShot (*first_shot)(const SolveOptions&) = nullptr;                     ///< null: none
    /// Stages whose lines can be followed one by one, as `explain --stage` names them, in their order.
    std::string_view told = {};
    /// For a method that only counts its lines: the one whose lines the page tells instead.
    std::string_view told_as = {};
};

/// One of the table's methods.
class Method
{
public:
    explicit constexpr Method(const MethodInfo* info) : info_(info) {}

    static const Method local, global, first_shot, extended, reuse, jacobi, transillumination, gathering;

    const MethodInfo* operator->() const { return info_; }
    friend bool operator==(Method a, Method b) { return a.info_ == b.info_; }
    friend bool operator!=(Method a, Method b) { return a.info_ != b.info_; }

private:
    const MethodInfo* info_;
};

/// All methods, in the order in which help lists them.
std::vector<Method> all_methods();

/// Throws std::invalid_argument for a name that is not in the table.
Method method_named(std::string_view name);

/// One of MethodInfo::options.
struct MethodOption
{
    std::string_view name;
    std::string_view with; ///< "direct=shoot": option and value that it needs; empty: none
};

std::vector<MethodOption> options_of(Method method);

/// True if an option of this name, such as "chords", has an effect with the method, whatever the other options.
bool has_option(Method method, std::string_view option);

/// The names in MethodInfo::told, one by one.
std::vector<std::string_view> told_stages(Method method);

} // namespace multipath
