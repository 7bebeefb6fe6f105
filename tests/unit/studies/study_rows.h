#pragma once

#include "sim/studies/study.h"

/// Studies that tests run separately.
namespace csgsim::studies {

extern const StudyRow compare_row;
extern const StudyRow corpus_row;
extern const StudyRow explore_row;
extern const StudyRow sweep_row;

}  // namespace csgsim::studies
