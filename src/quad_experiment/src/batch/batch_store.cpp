#include "quad_experiment/batch_store.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "quad_experiment/batch_row.hpp"
#include "quad_experiment/version.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/command_line.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/sha256.hpp"

namespace quad_experiment {
namespace {

namespace fs = std::filesystem;
using quad_support::EnvironmentError;

constexpr const char* kManifest = "/manifest.json";

void makeFolder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw EnvironmentError(fmt::format("cannot create {}: {}", path, error.message()));
}

/// A file that only this process holds, as long as the result lives. @throws EnvironmentError if
/// another one does
std::shared_ptr<void> lockFile(const std::string& path, bool wait) {
  const int fd = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (fd < 0)
    throw EnvironmentError(fmt::format("cannot create {}: {}", path, std::strerror(errno)));
  while (::flock(fd, wait ? LOCK_EX : LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    if (error == EINTR) continue;
    ::close(fd);
    if (error == EWOULDBLOCK)
      throw EnvironmentError(fmt::format(
          "{} is locked: another process flies these runs; wait for its end, or end it", path));
    throw EnvironmentError(fmt::format("cannot lock {}: {}", path, std::strerror(error)));
  }
  return {nullptr, [fd](void*) { ::close(fd); }};
}

bool isBeginning(const std::string& name) { return name.find(".partial-") != std::string::npos; }

/// The names in a folder; none if there is no folder.
std::vector<std::string> namesIn(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    names.push_back(it->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// "0000000000-0000000050.csv", perhaps followed by ".partial-…".
std::optional<RunRange> rangeOf(const std::string& name) {
  RunRange range;
  const char* const end = name.data() + name.size();
  auto part = std::from_chars(name.data(), end, range.first);
  if (part.ec != std::errc() || part.ptr == end || *part.ptr != '-') return std::nullopt;
  part = std::from_chars(part.ptr + 1, end, range.last);
  if (part.ec != std::errc() ||
      name.compare(static_cast<std::size_t>(part.ptr - name.data()), 4, ".csv") != 0 ||
      range.last <= range.first)
    return std::nullopt;
  return range;
}

bool overlap(RunRange a, RunRange b) { return a.first < b.last && b.first < a.last; }

std::string checksumLine(const BatchSpec& spec, RunRange runs, const std::string& rows) {
  return fmt::format("# runs {} {} spec {} sha256 {}\n", runs.first, runs.last, spec.hash,
                     quad_support::sha256(rows));
}

nlohmann::ordered_json manifest(const BatchSpec& spec) {
  return {{"spec", fs::absolute(spec.path).lexically_normal().string()},
          {"settings", fs::absolute(spec.base_path).lexically_normal().string()},
          {"hash", spec.hash},
          {"repeats", spec.repeats},
          {"points", spec.points},
          {"runs", spec.runs()},
          {"versions", {{"quad_experiment", quad_support::kVersion}, {"git", gitState()}}},
          {"columns", batchColumns(spec)}};
}

std::string hashInManifest(const std::string& path) {
  const auto j = nlohmann::json::parse(quad_support::readFile(path), nullptr, false);
  if (!j.is_object() || !j.contains("hash") || !j["hash"].is_string())
    throw quad_support::ConfigError(path + ": is no manifest of a batch; name another directory");
  return j["hash"].get<std::string>();
}

}  // namespace

BatchStore::BatchStore(const BatchSpec& spec, const std::string& path) : spec_(spec), path_(path) {}

BatchStore::BatchStore(const BatchSpec& spec, const std::string& path, IfBatchExists exists,
                       const std::string& lock)
    : spec_(spec), path_(path) {
  while (path_.size() > 1 && path_.back() == '/') path_.pop_back();
  if (path_.empty()) throw std::invalid_argument("the directory for the results has no name");
  if (fs::exists(path_) && !fs::is_directory(path_))
    throw std::invalid_argument(path_ + ": is not a directory; name another one");
  if (!fs::exists(path_ + kManifest)) {
    for (const std::string& name : namesIn(path_)) {
      if (name.rfind(".lock", 0) != 0 && !isBeginning(name))
        throw std::invalid_argument(
            path_ + ": exists and is not a batch (no manifest.json); name another directory");
    }
  } else if (exists == IfBatchExists::kRefuse) {
    throw std::invalid_argument(path_ +
                                ": exists already; --resume continues it, --force begins again");
  }
  makeFolder(path_);
  lock_ = lockFile(path_ + "/.lock" + lock, false);
  begin(exists);
}

void BatchStore::begin(IfBatchExists exists) {
  if (fs::exists(path_ + kManifest) && exists == IfBatchExists::kReplace) {
    std::error_code ignored;
    fs::remove(path_ + kManifest, ignored);  // first: without it the rest is not a batch
    for (const char* name : {"chunks", "results.csv", "spec.yaml", "settings.yaml"})
      fs::remove_all(path_ + "/" + name, ignored);
  }
  if (fs::exists(path_ + kManifest)) {
    const std::string before = hashInManifest(path_ + kManifest);
    if (before != spec_.hash) {
      throw quad_support::ConfigError(
          fmt::format("{}: was begun with another spec, number of runs, settings file, vehicle or "
                      "program (hash "
                      "{:.12}…, now {:.12}…); give those again, or --force to begin again",
                      path_, before, spec_.hash));
    }
  } else {
    quad_support::writeFileAtomically(path_ + kManifest, manifest(spec_).dump(2) + "\n");
  }
  makeFolder(path_ + "/chunks");
  quad_support::writeFileAtomically(path_ + "/spec.yaml", quad_support::readFile(spec_.path));
  quad_support::writeFileAtomically(path_ + "/settings.yaml", spec_.base_text);
}

std::string BatchStore::chunkPath(RunRange runs) const {
  return fmt::format("{}/chunks/{:010}-{:010}.csv", path_, runs.first, runs.last);
}

void BatchStore::writeChunk(RunRange runs, const std::string& rows) {
  quad_support::writeFileAtomically(chunkPath(runs), checksumLine(spec_, runs, rows) + rows);
}

std::vector<RunRange> BatchStore::chunks(RunRange runs) const {
  std::vector<RunRange> found;
  for (const std::string& name : namesIn(path_ + "/chunks")) {
    const auto range = rangeOf(name);
    if (range && !isBeginning(name) && overlap(*range, runs)) found.push_back(*range);
  }
  std::sort(found.begin(), found.end(), [](RunRange a, RunRange b) {
    return std::pair(a.first, a.last) < std::pair(b.first, b.last);
  });
  return found;
}

bool BatchStore::readChunk(RunRange runs, std::string& rows, std::string& problem) const {
  try {
    rows = quad_support::readFile(chunkPath(runs));
  } catch (const std::invalid_argument& e) {
    problem = e.what();
    return false;
  }
  const auto end = rows.find('\n');
  const std::string line = rows.substr(0, end == std::string::npos ? 0 : end + 1);
  rows.erase(0, line.size());
  if (line == checksumLine(spec_, runs, rows) &&
      std::count(rows.begin(), rows.end(), '\n') == runs.size())
    return true;
  problem = chunkPath(runs) + ": does not agree with its checksum";
  return false;
}

void BatchStore::removeBeginnings(RunRange runs) const {
  std::error_code ignored;
  for (const std::string& name : namesIn(path_ + "/chunks")) {
    const auto range = rangeOf(name);
    if (range && isBeginning(name) && overlap(*range, runs))
      fs::remove(path_ + "/chunks/" + name, ignored);
  }
}

std::vector<RunRange> BatchStore::missing(RunRange runs) {
  removeBeginnings(runs);
  std::vector<RunRange> gaps;
  std::int64_t next = runs.first;
  std::string rows, problem;
  for (const RunRange chunk : chunks(runs)) {
    if (!readChunk(chunk, rows, problem)) {
      std::fprintf(stderr, "%s; its runs are flown again\n", problem.c_str());
      std::error_code ignored;
      fs::remove(chunkPath(chunk), ignored);
      continue;
    }
    if (chunk.first > next) gaps.push_back({next, chunk.first});
    next = std::max(next, chunk.last);
  }
  if (next < runs.last) gaps.push_back({next, runs.last});
  return gaps;
}

bool BatchStore::merge() {
  const std::shared_ptr<void> lock = lockFile(path_ + "/.lock-merge", true);
  const RunRange all{0, spec_.runs()};
  std::int64_t next = 0;
  for (const RunRange chunk : chunks(all)) {
    if (chunk.first > next) return false;
    next = std::max(next, chunk.last);
  }
  if (next < all.last) return false;

  for (const std::string& name : namesIn(path_)) {  // of a merge that was killed
    if (name.rfind("results.csv.partial-", 0) == 0) fs::remove(path_ + "/" + name);
  }
  quad_support::AsideFile out(resultsPath());
  std::string header;
  for (const std::string& name : batchColumns(spec_)) header += (header.empty() ? "" : ",") + name;
  out.append(header + "\n");
  next = 0;
  std::string rows, problem;
  for (const RunRange chunk : chunks(all)) {
    if (chunk.last <= next) continue;
    if (!readChunk(chunk, rows, problem))
      throw EnvironmentError(problem + "; --resume flies its runs again");
    std::size_t at = 0;
    for (std::int64_t run = chunk.first; run < next; ++run) at = rows.find('\n', at) + 1;
    out.append(std::string_view(rows).substr(at));
    next = chunk.last;
  }
  out.commit();
  return true;
}

}  // namespace quad_experiment
