#pragma once

#include "sim/app/command_line.h"
#include "sim/study/gather.h"

namespace csgsim::app {

/// Studies that can be shared out: command_NAME.cpp describes in gather_NAME the command NAME that measures nothing,
/// but has the rows that were gathered.
#define CSGSIM_STUDIES(STUDY) \
  STUDY(accuracy)             \
  STUDY(sweep)                \
  STUDY(compare)              \
  STUDY(corpus)

#define CSGSIM_STUDY_DECLARATION(name) void gather_##name(CommandLine& line, const study::Gathered& gathered);
CSGSIM_STUDIES(CSGSIM_STUDY_DECLARATION)
#undef CSGSIM_STUDY_DECLARATION

}  // namespace csgsim::app
