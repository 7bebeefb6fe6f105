# cmake -DSOURCE=... -DCOMMIT=... -DOUTPUT=... -P commit.cmake: writes commit.cpp, if its contents change. COMMIT is
# used if the sources are not in a git repository.
set(date "")
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --show-toplevel OUTPUT_VARIABLE top RESULT_VARIABLE failed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH ${SOURCE} real)
  # The source archive may be unpacked inside another project's repository.
  if(NOT failed AND top STREQUAL real)
    execute_process(COMMAND ${GIT} -C ${SOURCE} log -1 --format=%h --abbrev=12 OUTPUT_VARIABLE commit
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${GIT} -C ${SOURCE} log -1 --format=%cs OUTPUT_VARIABLE date
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${GIT} -C ${SOURCE} diff --quiet HEAD -- RESULT_VARIABLE changed ERROR_QUIET)
    if(commit AND changed)
      string(APPEND commit "+changes")
    endif()
  endif()
endif()
if(NOT commit)
  set(commit "${COMMIT}")
endif()
if(NOT commit)
  set(commit unknown)
endif()
if(NOT date)
  file(TIMESTAMP ${SOURCE}/CMakeLists.txt date %Y-%m-%d UTC)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "sim/session/options/commit.h"

namespace csgsim::session {

const char* const commit = "@commit@";
const char* const commit_date = "@date@";

}  // namespace csgsim::session
]])
