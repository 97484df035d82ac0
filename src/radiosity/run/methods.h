#pragma once

#include "transport/lines/global_lines.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace multipath {

class Run;
class Scene;
struct Preparation;
struct SolveOptions;

/// A function for one part of a run (run.h), such as the first shot. It advances the state of the run, and can be
/// interrupted and resumed.
using Stage = void (*)(Run&);
using Stages = std::array<Stage, 3>; ///< in order; a null does nothing

/// How the results of shards (runs that divide the lines of one run, usually on several computers) are combined.
/// averaged: each shard is a solution of its own, and the result is their mean, weighted by their lines. added: each
/// shard is a set of counts, and the counts are added before the linear system is solved.
enum class Shards { averaged, added };

/// Rays from bright patches before all other lines: none, rays from the sources (first_shot.h), or passes over all
/// patches (extended_first_shot.h).
enum class FirstShot { none, plain, extended };

/// A method: one row of the table in methods.cpp. To add a method, write its stages and add a row; command line, help,
/// study, selftest, page and tests iterate over the table.
struct MethodInfo
{
    std::string_view name;
    std::string_view summary; ///< whole sentences, for help
    /// Command line options of this method that not all methods have, separated by spaces. The entry
    /// "steps:direct=shoot" means that the option `steps` has an effect only if the option `direct` is `shoot`.
    std::string_view options;
    Stages stages;
    /// Stages whose lines can be traced one by one, in order, separated by spaces: the values of `explain --stage`. In
    /// "extended:PASS", PASS stands for the number of a pass.
    std::string_view traced;
    /// Sets the part of Preparation (solve.h) that the method needs. Null if it needs none.
    void (*prepare)(const Scene&, const SolveOptions&, Preparation&) = nullptr;
    FirstShot first_shot = FirstShot::none; ///< of `reuse`, if the option `direct` is `shoot`
    Chords chords = Chords::sphere;         ///< default distribution of the global lines
    Shards shards = Shards::averaged;
    /// Lines per patch that each replicate needs before the scatter of replicates is a good estimate of the error. Null
    /// if any number will do.
    std::uint64_t (*lines_per_patch)(const Scene&) = nullptr;
    /// For a method whose `traced` is empty: name of the method whose lines the interactive page shows instead.
    std::string_view traced_as = {};
};

/// A handle to one row of the table.
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

/// All methods, in the order of the help text.
std::vector<Method> all_methods();

/// The method of this name. Throws std::invalid_argument if there is none.
Method method_named(std::string_view name);

/// One entry of MethodInfo::options.
struct MethodOption
{
    std::string_view name;
    std::string_view with; ///< another option and its required value, such as "direct=shoot"; empty: none is required
};

/// The entries of MethodInfo::options, in order.
std::vector<MethodOption> options_of(Method method);

/// True if the option, such as "chords", has an effect with this method whatever the other options are. False for an
/// option that requires the value of another one (MethodOption::with).
bool has_option(Method method, std::string_view option);

/// The names in MethodInfo::traced as a list.
std::vector<std::string_view> traced_stages(Method method);

} // namespace multipath
