// Creation of methods without coherence.
// Used by the rows of weave, interval-lists and interval-arithmetic.
#pragma once

#include <memory>

#include "sim/software/methods/rows.h"
#include "sim/software/traversals/levels.h"

namespace csgsim::software {

/// Creates a method that takes no coherence and descends the tree recursively.
template <template <class> class Whole>
std::unique_ptr<Method> make_whole(Coherent /*coherence*/, const Subject& subject, bool counts) {
  refuse_deep(subject.tree, max_calls);
  if (counts) return std::make_unique<Whole<CountingMethod>>(subject);
  return std::make_unique<Whole<UncountedMethod>>(subject);
}

}  // namespace csgsim::software
