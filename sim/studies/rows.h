// The table of all studies.
// Used by sim/app and sim/python.
#pragma once

#include <span>

#include "sim/studies/study.h"

namespace csgsim::studies {

/// All studies, in the order in which help lists them.
std::span<const StudyRow* const> all();

}  // namespace csgsim::studies
