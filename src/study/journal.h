#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace multipath {

/// Identifies an execution (run) of a study.
struct ExecutionKey
{
    std::string curve; ///< name of the curve, without tabs and line ends
    std::uint64_t lines = 0;
    int number = 0; ///< index of the execution among those with the same curve and lines
};

/// Result of one execution.
struct Execution
{
    std::uint64_t local_lines = 0;  ///< N_l, number of lines cast locally
    std::uint64_t global_lines = 0; ///< N_g, number of lines cast globally
    double mean_square = 0.0;       ///< [W^2/m^4] MSE, (1) in docs/equations.md
    double relative = 0.0;          ///< [1] relative MSE
    double seconds = 0.0;           ///< [s] processor time on one thread
};

/// Log of the finished executions of a study in a file, from which an interrupted study resumes. Each execution is one
/// line with a checksum; lines that a crash left incomplete are ignored. Thread-safe.
class Journal
{
public:
    /// A journal without a file, for a study that cannot be resumed.
    Journal() = default;

    /// Reads the file, if it exists, and appends to it from then on. `identity`, one line, describes the study whose
    /// executions the file holds. A file with another identity is overwritten. Throws std::runtime_error with the
    /// reason if the file cannot be written.
    Journal(const std::string& path, const std::string& identity);

    /// Returns the result of an execution; nothing if it is not in the journal.
    std::optional<Execution> find(const ExecutionKey& key) const;

    /// Records an execution and writes it into the file at once. Throws std::runtime_error if the file cannot be
    /// written.
    void add(const ExecutionKey& key, const Execution& execution);

private:
    void append(const std::string& line);

    mutable std::mutex mutex_;
    std::map<std::string, Execution> executions_;
    std::string path_; ///< empty: no file
    std::ofstream file_;
};

} // namespace multipath
