#pragma once

#include <string>

#include "host/model/tree.h"

namespace csgsim::read_test {

/// What a tree breaks of the promises of tree.h and read.h; empty if nothing. Shared with the fuzzers.
std::string broken_promise(const model::Tree& tree);

}  // namespace csgsim::read_test
