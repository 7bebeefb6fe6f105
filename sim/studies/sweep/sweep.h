#pragma once

#include "sim/studies/study.h"

namespace csgsim::studies {

extern const StudyRow sweep_row;

}  // namespace csgsim::studies
