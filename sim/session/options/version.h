#pragma once

#include <string>

namespace csgsim::session {

/// The program's version, as in `0.1.0`.
std::string version();

/// The version and what the linker calls this build, as in `0.1.0 3f2a...`: different code has a different text.
std::string version_and_build();

/// Lines for people: version, commit, build, and the libraries that it was built with.
std::string version_page();

/// Day of the commit, as in 2001-12-31; outside of git, of the sources.
std::string date_of_sources();

}  // namespace csgsim::session
