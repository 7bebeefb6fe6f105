#pragma once

#include "sim/studies/study.h"

namespace csgsim::testing {

/// A study unrelated to csgsim: the number of steps in which the numbers of a file reach 1. It shows that a new study
/// needs nothing but its row.
extern const studies::StudyRow collatz_row;

}  // namespace csgsim::testing
