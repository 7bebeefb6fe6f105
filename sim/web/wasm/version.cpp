// Replaces sim/session/options/version.cpp, which reads the build ID written by the linker.
#include "sim/session/options/version.h"

#include "sim/session/options/commit.h"

namespace csgsim::session {

std::string version() { return CSGSIM_VERSION; }

std::string version_and_build() { return version() + " " + commit; }

std::string source_date() { return commit_date; }

}  // namespace csgsim::session
