#pragma once

#include "sim/studies/study.h"

namespace csgsim::studies {

extern const StudyRow accuracy_row;

}  // namespace csgsim::studies
