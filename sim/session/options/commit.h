// The commit that csgsim was built from.
// Used by sim/session and sim/web.
#pragma once

namespace csgsim::session {

// cmake/commit.cmake regenerates commit.cpp at each build if the commit has changed.

/// Abbreviated commit hash, with `+changes` if tracked files differ from it; `unknown` outside of git.
extern const char* const commit;

/// Date of the commit, as in 2001-12-31; outside of git, of the sources.
extern const char* const commit_date;

}  // namespace csgsim::session
