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
    std::string curve; ///< its name, without tabs and line ends
    std::uint64_t lines = 0;
    int number = 0; ///< index among the executions of the same curve and lines
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
    /// A journal without a file.
    Journal() = default;

    /// Reads the file, if it exists, and appends to it. `identity` describes in one line the study whose runs it holds;
    /// a file with another identity is overwritten. Throws std::runtime_error with the reason if the file cannot be
    /// written.
    Journal(const std::string& path, const std::string& identity);

    /// The result of a finished execution; nothing if it is not in the journal.
    std::optional<Execution> find(const ExecutionKey& key) const;

    /// Records an execution, in the file at once. Throws std::runtime_error if the file cannot be written.
    void add(const ExecutionKey& key, const Execution& execution);

private:
    void append(const std::string& line);

    mutable std::mutex mutex_;
    std::map<std::string, Execution> executions_;
    std::string path_; ///< empty: no file
    std::ofstream file_;
};

} // namespace multipath
