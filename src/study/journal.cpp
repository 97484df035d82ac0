#include "study/journal.h"

#include "image/checksum.h"
#include "scene/text/text_format.h"

#include <cerrno>
#include <cinttypes>
#include <cstring>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace multipath {

namespace {

std::string key_text(const ExecutionKey& key)
{
    return key.curve + "\t" + std::to_string(key.lines) + "\t" + std::to_string(key.number);
}

std::string checksum_text(const std::string& text)
{
    return format("%08" PRIx32, crc32(text));
}

std::string values_text(const Execution& e)
{
    return format("\t%" PRIu64 "\t%" PRIu64 "\t%.17g\t%.17g\t%.17g", e.local_lines, e.global_lines, e.mean_square,
                  e.relative, e.seconds);
}

/// Parses a record. Nothing if its checksum is wrong or it is malformed.
std::optional<std::pair<std::string, Execution>> parsed(const std::string& line)
{
    const std::size_t end = line.rfind('\t');
    if (end == std::string::npos || checksum_text(line.substr(0, end)) != line.substr(end + 1))
        return {};
    std::istringstream fields(line.substr(0, end));
    fields.imbue(std::locale::classic());
    ExecutionKey key;
    Execution e;
    std::getline(fields, key.curve, '\t');
    if (!(fields >> key.lines >> key.number >> e.local_lines >> e.global_lines >> e.mean_square >> e.relative >>
          e.seconds))
        return {};
    return std::pair{key_text(key), e};
}

} // namespace

Journal::Journal(const std::string& path, const std::string& identity) : path_(path)
{
    std::ifstream lines(path, std::ios::binary);
    std::string line;
    if (std::getline(lines, line) && line == identity)
        while (std::getline(lines, line))
            if (const auto record = parsed(line))
                executions_[record->first] = record->second;
    const bool fresh = executions_.empty();
    file_.open(path, std::ios::binary | (fresh ? std::ios::trunc : std::ios::app));
    append(fresh ? identity : ""); // a line feed ends a record that a crash may have cut off
}

void Journal::append(const std::string& line)
{
    if (!(file_ << line << '\n' << std::flush))
        throw std::runtime_error("cannot write " + path_ + ": " + std::strerror(errno));
}

std::optional<Execution> Journal::find(const ExecutionKey& key) const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = executions_.find(key_text(key));
    return found == executions_.end() ? std::nullopt : std::optional(found->second);
}

void Journal::add(const ExecutionKey& key, const Execution& execution)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    executions_[key_text(key)] = execution;
    const std::string text = key_text(key) + values_text(execution);
    if (!path_.empty())
        append(text + "\t" + checksum_text(text));
}

} // namespace multipath
