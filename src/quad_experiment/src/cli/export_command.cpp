#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "commands.hpp"
#include "quad_support/errors.hpp"

namespace {

namespace fs = std::filesystem;

/// The folder of generated message modules of the tree this program was built or installed into,
/// put in front of PYTHONPATH, so that the workspace's setup.sh need not be sourced.
void addMessageModules(const fs::path& bin) {
  const fs::path modules = bin / "../python3/dist-packages";
  std::error_code ignored;
  if (!fs::is_directory(modules, ignored)) return;
  const char* before = std::getenv("PYTHONPATH");
  const std::string path =
      fs::canonical(modules).string() + (before && *before ? ":" + std::string(before) : "");
  ::setenv("PYTHONPATH", path.c_str(), 1);
}

}  // namespace

int exportRun(const ExportOptions& options) {
  std::vector<std::string> arguments = {"export_run", options.results};
  const auto add = [&](bool wanted, const char* flag) {
    if (wanted) arguments.emplace_back(flag);
  };
  add(options.bag, "--bag");
  add(options.mat, "--mat");
  add(options.parquet, "--parquet");
  add(options.plotjuggler, "--plotjuggler");
  if (arguments.size() == 2) {
    throw quad_support::ConfigError(
        "export: no format; give --bag, --mat, --parquet or --plotjuggler, one or more");
  }
  if (!options.out.empty()) arguments.insert(arguments.end(), {"--out", options.out});

  const fs::path bin = fs::read_symlink("/proc/self/exe").parent_path();
  const std::string exporter = (bin / arguments[0]).string();
  addMessageModules(bin);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  ::execv(exporter.c_str(), argv.data());
  const int error = errno;  // execv() comes back only when it failed
  // A script whose interpreter is not there is reported as missing itself.
  const bool present = ::access(exporter.c_str(), F_OK) == 0;
  throw quad_support::EnvironmentError(
      present ? fmt::format("export needs Python ({}: {}); run: apt-get install python3", exporter,
                            std::strerror(error))
              : fmt::format("export: {} is not there; run: make build", exporter));
}
