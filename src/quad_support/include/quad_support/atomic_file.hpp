/// Files and result directories that are complete or absent, never half-written.
#pragma once

#include <string>
#include <string_view>

namespace quad_support {

/// Writes `content` beside `path`, flushes it to the disk and renames it into place. A device, pipe
/// or socket there (/dev/null, /dev/stdout) stays and is written to.
/// @throws EnvironmentError naming path and reason, std::invalid_argument if `path` is a directory;
/// what was there is then as before
void writeFileAtomically(const std::string& path, std::string_view content);

/// A file too large for memory, written in pieces beside `path`. Without commit() nothing is left
/// of it.
class AsideFile {
 public:
  /// @throws as writeFileAtomically()
  explicit AsideFile(const std::string& path);
  ~AsideFile();
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  void append(std::string_view content);  ///< @throws EnvironmentError
  void commit();  ///< flushes to the disk and renames into place; @throws EnvironmentError

 private:
  std::string path_, aside_;
  int fd_ = -1;
};

/// @throws std::invalid_argument (bad input) naming path and reason
std::string readFile(const std::string& path);

/// A directory of results: filled aside as `.<name>.partial-<pid>`, moved to its name by commit().
/// Without commit() nothing is left.
class ResultDirectory {
 public:
  /// @param path       where the results shall be
  /// @param overwrite  false: @throws std::invalid_argument if `path` exists (nothing is touched);
  /// true: replaces an empty
  ///                   directory or an older one of results (it holds config.yaml, provenance.json
  ///                   or summary.json), and
  ///                   @throws std::invalid_argument for anything else there, so that nobody's
  ///                   other files are lost
  /// @throws EnvironmentError if the place cannot be written
  ResultDirectory(const std::string& path, bool overwrite);
  ~ResultDirectory();
  ResultDirectory(const ResultDirectory&) = delete;
  ResultDirectory& operator=(const ResultDirectory&) = delete;

  const std::string& path() const { return final_; }
  const std::string& workPath() const { return work_; }

  /// Writes a file into the directory; subdirectories in `name` are made. @throws EnvironmentError
  void write(const std::string& name, std::string_view content);

  /// Renames into place; an older directory there is removed only after the new one has taken its
  /// name.
  void commit();

 private:
  std::string final_, work_;
  bool overwrite_, committed_ = false;
};

}  // namespace quad_support
