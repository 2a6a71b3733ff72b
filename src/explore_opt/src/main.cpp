#include "cli/commands.hpp"
#include "quad_support/program.hpp"

int main(int argc, char** argv) {
  return quad_support::runProgram("explore_opt",
                                  [argc, argv] { return explore_opt::runCommandLine(argc, argv); });
}
