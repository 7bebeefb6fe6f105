#pragma once

#include "host/model/tree.h"
#include "tests/oracle/split_mix.h"

namespace csgsim::testing {

/// A tree with the given number of primitives; operators have two to four operands.
model::Tree random_tree(Random& random, unsigned primitives);

/// A left-leaning chain of operators, each over the preceding chain and one more primitive.
model::Tree chain(unsigned primitives);

}  // namespace csgsim::testing
