#include "quad_experiment/version.hpp"

#include "quad_git_state.h"

namespace quad_experiment {

const char* const kCompiler = "g++ " __VERSION__;
const char* const kOdeVersion = QUAD_ODE_VERSION;
const char* const kIpoptVersion = QUAD_IPOPT_VERSION;

const char* gitState() { return QUAD_GIT_STATE; }

}  // namespace quad_experiment
