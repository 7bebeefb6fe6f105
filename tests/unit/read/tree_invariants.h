#pragma once

#include <string>

#include "host/model/tree.h"

namespace csgsim::read_test {

/// Returns the first invariant of tree.h and read.h that a tree violates; empty if none. Shared with the fuzzers.
std::string broken_invariant(const model::Tree& tree);

}  // namespace csgsim::read_test
