// Version, build and date of csgsim.
// Used by sim/python, sim/shell, sim/studies, sim/suite and sim/web.
#pragma once

#include <string>

namespace csgsim::session {

/// Version of the program, as in `0.1.0`.
std::string version();

/// Version and build ID, as in `0.1.0 3f2a...`; different code has a different text.
std::string version_and_build();

/// Text of --version: version, commit, build, and the libraries it was built with.
std::string version_page();

/// Date of the commit, as in 2001-12-31; outside of git, of the sources.
std::string source_date();

}  // namespace csgsim::session
