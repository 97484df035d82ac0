#pragma once

#include "study/execution.h"

#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace multipath {

/// The finished runs of a study, kept in a file as they end, so that a study that was cut off goes on where it was.
/// Each run is one line with a checksum of its own: what a crash left half written is not read back. Safe to use from
/// several threads.
class Journal
{
public:
    /// Remembers nothing beyond this run of the program.
    Journal() = default;

    /// Reads what the file holds, if there is one, and appends to it. `identity` says in one line what the runs have in
    /// common; a file of another identity is begun anew. Throws std::runtime_error with the reason when the file cannot
    /// be written.
    Journal(const std::string& path, const std::string& identity);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    std::optional<Execution> find(const ExecutionKey& key) const;
    void add(const ExecutionKey& key, const Execution& execution);

private:
    void read(const std::string& text, const std::string& identity);
    void append(const std::string& line);

    mutable std::mutex mutex_;
    std::map<std::string, Execution> executions_;
    std::string path_;
    int descriptor_ = -1; ///< -1: none
};

} // namespace multipath
