#pragma once

#include "sim/studies/study.h"

namespace csgsim::studies {

extern const StudyRow advise_row;

}  // namespace csgsim::studies
