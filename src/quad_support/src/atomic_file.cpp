#include "quad_support/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <linux/fs.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "quad_support/errors.hpp"

namespace quad_support {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const std::string& action, const std::string& path, int error) {
  throw EnvironmentError(fmt::format("cannot {} {}: {}", action, path, std::strerror(error)));
}

void syncPath(const std::string& path, int flags) {
  const int fd = ::open(path.c_str(), flags);
  if (fd < 0) fail("open", path, errno);
  const int result = ::fsync(fd);
  const int error = errno;
  ::close(fd);
  if (result != 0 && error != EINVAL)
    fail("flush", path, error);  // EINVAL: this file system cannot sync
}

std::string parentOf(const std::string& path) {
  const std::string parent = fs::path(path).parent_path().string();
  return parent.empty() ? "." : parent;
}

/// A device, a pipe or a socket (/dev/null, /dev/stdout) takes the bytes itself: renaming a file
/// over it would do away with it for every program on the machine.
bool takesBytesItself(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// @param shown  the name in the complaint: the one that was asked for
int create(const std::string& path, const std::string& shown) {
  std::error_code ignored;
  if (fs::is_directory(shown, ignored))
    throw std::invalid_argument(shown + ": is a directory; name a file");
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (fd < 0) fail("create", shown, errno);
  return fd;
}

/// @returns errno, 0 if all was written
int writeAll(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = ::write(fd, content.data(), content.size());
    if (n > 0)
      content.remove_prefix(static_cast<std::size_t>(n));
    else if (n < 0 && errno != EINTR)
      return errno;
  }
  return 0;
}

/// @param error  of the writing before  @returns the first errno, 0 if the file is on the disk
int syncAndClose(int fd, int error) {
  if (error == 0 && ::fsync(fd) != 0 && errno != EINVAL && errno != ENOTSUP) error = errno;
  if (::close(fd) != 0 && error == 0) error = errno;
  return error;
}

void writeAndSync(const std::string& path, const std::string& shown, std::string_view content) {
  const int fd = create(path, shown);
  const int error = syncAndClose(fd, writeAll(fd, content));
  if (error != 0) {
    ::unlink(path.c_str());
    fail("write", shown, error);
  }
}

/// @throws std::invalid_argument unless what is at `path` is nobody's loss
void requireReplaceable(const std::string& path) {
  if (!fs::is_directory(path))
    throw std::invalid_argument(path + ": is not a directory; name another one");
  if (fs::is_empty(path)) return;
  for (const char* mark : {"config.yaml", "provenance.json", "summary.json"}) {
    if (fs::exists(fs::path(path) / mark)) return;
  }
  throw std::invalid_argument(
      path +
      ": holds other files than an experiment's results, so --force does not replace it; name "
      "another directory");
}

}  // namespace

void writeFileAtomically(const std::string& path, std::string_view content) {
  if (takesBytesItself(path)) {
    const int fd = create(path, path);
    const int error = syncAndClose(fd, writeAll(fd, content));
    if (error != 0) fail("write", path, error);
    return;
  }
  const std::string aside = fmt::format("{}.partial-{}", path, ::getpid());
  writeAndSync(aside, path, content);
  if (::rename(aside.c_str(), path.c_str()) != 0) {
    const int error = errno;
    ::unlink(aside.c_str());
    fail("rename a finished file to", path, error);
  }
  syncPath(parentOf(path), O_RDONLY | O_DIRECTORY);
}

AsideFile::AsideFile(const std::string& path)
    : path_(path),
      aside_(takesBytesItself(path) ? path : fmt::format("{}.partial-{}", path, ::getpid())),
      fd_(create(aside_, path)) {}

AsideFile::~AsideFile() {
  if (fd_ < 0) return;
  ::close(fd_);
  if (aside_ != path_) ::unlink(aside_.c_str());
}

void AsideFile::append(std::string_view content) {
  const int error = writeAll(fd_, content);
  if (error != 0) fail("write", path_, error);
}

void AsideFile::commit() {
  const int error = syncAndClose(std::exchange(fd_, -1), 0);
  if (error == 0 && aside_ == path_) return;
  if (error == 0 && ::rename(aside_.c_str(), path_.c_str()) == 0) {
    syncPath(parentOf(path_), O_RDONLY | O_DIRECTORY);
    return;
  }
  const int reason = error != 0 ? error : errno;
  if (aside_ != path_) ::unlink(aside_.c_str());
  fail("finish", path_, reason);
}

std::string readFile(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw std::invalid_argument(path + ": is a directory, not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw std::invalid_argument(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  std::string content((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) throw std::invalid_argument(path + ": reading failed");
  return content;
}

ResultDirectory::ResultDirectory(const std::string& path, bool overwrite)
    : final_(path), overwrite_(overwrite) {
  while (final_.size() > 1 && final_.back() == '/') final_.pop_back();
  const std::string name = fs::path(final_).filename().string();
  if (name.empty() || name == "." || name == "..") {
    throw std::invalid_argument("'" + path +
                                "' cannot be a results directory; give it a name of its own");
  }
  std::error_code error;
  if (fs::exists(fs::symlink_status(final_, error))) {
    if (fs::is_directory(final_, error) && !overwrite)
      throw std::invalid_argument(final_ +
                                  ": exists already; name another directory or give --force");
    requireReplaceable(final_);
  }
  const std::string parent = parentOf(final_);
  fs::create_directories(parent, error);
  if (error) fail("create", parent, error.value());
  work_ = fmt::format("{}/.{}.partial-{}", parent, name, ::getpid());
  fs::remove_all(work_, error);
  fs::create_directory(work_, error);
  if (error) fail("create", work_, error.value());
}

ResultDirectory::~ResultDirectory() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(work_, ignored);
}

void ResultDirectory::write(const std::string& name, std::string_view content) {
  const std::string path = work_ + "/" + name;
  std::error_code error;
  fs::create_directories(parentOf(path), error);
  if (error) fail("create", parentOf(path), error.value());
  writeAndSync(path, final_ + "/" + name, content);
}

void ResultDirectory::commit() {
  syncPath(work_, O_RDONLY | O_DIRECTORY);
  // An older directory and the new one swap names in one step, so there is no moment without
  // results.
  const bool exists = ::access(final_.c_str(), F_OK) == 0;
  if (exists && !overwrite_)
    throw std::invalid_argument(final_ + ": appeared meanwhile; nothing was overwritten");
  const unsigned flags = exists ? RENAME_EXCHANGE : RENAME_NOREPLACE;
  if (::renameat2(AT_FDCWD, work_.c_str(), AT_FDCWD, final_.c_str(), flags) != 0) {
    fail("rename finished results to", final_, errno);
  }
  committed_ = true;
  std::error_code ignored;
  if (exists) fs::remove_all(work_, ignored);
  syncPath(parentOf(final_), O_RDONLY | O_DIRECTORY);
}

}  // namespace quad_support
