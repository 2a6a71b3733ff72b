#include "worker_process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <utility>

#include "quad_support/errors.hpp"

namespace quad_experiment {
namespace {

[[noreturn]] void failToStart() {
  throw quad_support::EnvironmentError(
      fmt::format("cannot start a worker process: {}", std::strerror(errno)));
}

/// In the child, between fork and exec: system calls only.
[[noreturn]] void become(char* const* arguments, int in, int out, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::setpgid(0, 0);  // Ctrl-C reaches the pool, which then asks its workers, once
  if (::getppid() == parent && ::dup2(in, STDIN_FILENO) >= 0 && ::dup2(out, STDOUT_FILENO) >= 0)
    ::execv("/proc/self/exe", arguments);
  ::_exit(127);
}

}  // namespace

WorkerProcess::WorkerProcess(const std::vector<std::string>& arguments) {
  std::vector<char*> words = {const_cast<char*>("quad_experiment")};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  std::signal(SIGPIPE, SIG_IGN);  // a dead worker is seen by its closed pipe
  int to[2], from[2];
  if (::pipe2(to, O_CLOEXEC) != 0) failToStart();
  if (::pipe2(from, O_CLOEXEC) != 0) {
    ::close(to[0]);
    ::close(to[1]);
    failToStart();
  }
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) become(words.data(), to[0], from[1], parent);
  ::close(to[0]);
  ::close(from[1]);
  to_ = to[1];
  from_ = from[0];
  if (pid_ < 0) {
    ::close(to_);
    ::close(from_);
    failToStart();
  }
}

WorkerProcess::~WorkerProcess() {
  kill();
  if (to_ >= 0) ::close(to_);
  ::close(from_);
}

void WorkerProcess::give(const Chunk& chunk) {
  chunk_ = chunk;
  run_ = -1;
  const std::string line = fmt::format("{} {}\n", chunk.runs.first, chunk.runs.last);
  [[maybe_unused]] const ssize_t n = ::write(to_, line.data(), line.size());
}

std::vector<std::string> WorkerProcess::readLines(bool& ended) {
  char block[4096];
  const ssize_t n = ::read(from_, block, sizeof(block));
  if (n > 0) buffer_.append(block, static_cast<std::size_t>(n));
  ended = n == 0 || (n < 0 && errno != EINTR && errno != EAGAIN);
  std::vector<std::string> lines;
  for (std::size_t end; (end = buffer_.find('\n')) != std::string::npos; buffer_.erase(0, end + 1))
    lines.push_back(buffer_.substr(0, end));
  return lines;
}

double WorkerProcess::processorTime() const {
  clockid_t clock;
  timespec t{};
  if (::clock_getcpuclockid(pid_, &clock) != 0 || ::clock_gettime(clock, &t) != 0) return 0.0;
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void WorkerProcess::beginRun(std::int64_t run) {
  run_ = run;
  processor_at_start_ = processorTime();
  wall_at_start_ = std::chrono::steady_clock::now();
}

double WorkerProcess::processorSeconds() const {
  return run_ < 0 ? 0.0 : processorTime() - processor_at_start_;
}

double WorkerProcess::wallSeconds() const {
  if (run_ < 0) return 0.0;
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_at_start_).count();
}

void WorkerProcess::askToStop() {
  if (pid_ > 0) ::kill(pid_, SIGTERM);
  ::close(std::exchange(to_, -1));  // and if it waits for work, there is none
}

bool WorkerProcess::waitFor(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (pid_ > 0) {
    const pid_t ended = ::waitpid(pid_, nullptr, WNOHANG);
    if (ended == pid_ || (ended < 0 && errno == ECHILD)) {
      pid_ = -1;
    } else if (std::chrono::steady_clock::now() > end) {
      return false;
    } else {
      ::usleep(2000);
    }
  }
  return true;
}

void WorkerProcess::kill() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
}

}  // namespace quad_experiment
