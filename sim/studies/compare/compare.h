#pragma once

#include "sim/studies/study.h"

namespace csgsim::studies {

extern const StudyRow compare_row;

}  // namespace csgsim::studies
