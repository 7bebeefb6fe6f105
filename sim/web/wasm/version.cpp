// In place of sim/session/options/version.cpp, which reads what the linker of this machine has written.
#include "sim/session/options/version.h"

#include "sim/session/options/commit.h"

namespace csgsim::session {

std::string version() { return CSGSIM_VERSION; }

std::string version_and_build() { return version() + " " + commit; }

std::string date_of_sources() { return commit_date; }

}  // namespace csgsim::session
