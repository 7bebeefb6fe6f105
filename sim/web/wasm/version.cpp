// In place of sim/shell/version.cpp, which reads what the linker of this machine has written.
#include "sim/shell/version.h"

#include "sim/shell/commit.h"

namespace csgsim::shell {

std::string version() { return CSGSIM_VERSION; }

std::string version_and_build() { return version() + " " + commit; }

std::string date_of_sources() { return commit_date; }

}  // namespace csgsim::shell
