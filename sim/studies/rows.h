// The table of all studies.
// Used by the application, the page server and csgsim gather.
#pragma once

#include <span>

#include "sim/studies/study.h"

namespace csgsim::studies {

/// All studies, in the order in which help lists them.
std::span<const StudyRow* const> all();

}  // namespace csgsim::studies
