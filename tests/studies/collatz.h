#pragma once

#include "sim/studies/study.h"

namespace csgsim::testing {

/// A study of nothing that csgsim knows: how many steps numbers of a file take to 1. What a new study needs of the rest
/// of the house is nothing but its row.
extern const studies::StudyRow collatz_row;

}  // namespace csgsim::testing
