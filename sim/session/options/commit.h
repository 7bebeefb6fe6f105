#pragma once

namespace csgsim::session {

// cmake/commit.cmake writes commit.cpp at each build, if it has changed.

/// As git abbreviates it, `+changes` if files differ from it; `unknown` outside of git.
extern const char* const commit;

/// Day of the commit, as in 2001-12-31; outside of git, of the sources.
extern const char* const commit_date;

}  // namespace csgsim::session
