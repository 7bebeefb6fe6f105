#pragma once

#include <span>

#include "sim/studies/study.h"

namespace csgsim::studies {

/// Every study, in the order of help.
std::span<const StudyRow* const> all();

}  // namespace csgsim::studies
