#pragma once

#include "sim/studies/study.h"

namespace csgsim::studies {

extern const StudyRow corpus_row;

}  // namespace csgsim::studies
