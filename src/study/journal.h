#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace multipath {

/// Identifies an execution of a study.
struct ExecutionKey
{
    std::string curve; ///< a name without tabs and line ends
    std::uint64_t lines = 0;
    int number = 0; ///< among those with the same curve and lines
};

/// Result of one run of a study.
struct Execution
{
    std::uint64_t local_lines = 0;  ///< N_l
    std::uint64_t global_lines = 0; ///< N_g
    double mean_square = 0.0;       ///< MSE (1) [W^2/m^4]
    double relative = 0.0;          ///< relative MSE [1]
    double seconds = 0.0;           ///< [s] processor time on one thread
};

/// Log of the finished runs of a study in a file, from which an interrupted study resumes. Each run is one line with a
/// checksum of its own; lines that a crash left incomplete are ignored. Thread-safe.
class Journal
{
public:
    /// Without a file.
    Journal() = default;

    /// Reads what the file holds, if there is one, and appends to it. `identity` says in one line what the runs have in
    /// common; a file of another identity is begun anew. Throws std::runtime_error with the reason when the file cannot
    /// be written.
    Journal(const std::string& path, const std::string& identity);

    std::optional<Execution> find(const ExecutionKey& key) const;
    void add(const ExecutionKey& key, const Execution& execution);

private:
    void append(const std::string& line);

    mutable std::mutex mutex_;
    std::map<std::string, Execution> executions_;
    std::string path_; ///< empty: none
    std::ofstream file_;
};

} // namespace multipath
