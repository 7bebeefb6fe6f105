#pragma once

#include "host/model/tree.h"
#include "tests/oracle/split_mix.h"

namespace csgsim::testing {

/// A tree of that many primitives, of operators over two to four operands.
model::Tree random_tree(Random& random, unsigned primitives);

/// Operators, one after the other from the left, each over what is left of it and one primitive more.
model::Tree chain(unsigned primitives);

}  // namespace csgsim::testing
