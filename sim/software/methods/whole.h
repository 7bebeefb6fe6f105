#pragma once

#include <memory>

#include "sim/software/methods/rows.h"

namespace csgsim::software {

/// A method that takes no coherence.
template <template <class> class Whole>
std::unique_ptr<Method> whole(Coherent /*coherence*/, const Subject& subject, bool counts) {
  if (counts) return std::make_unique<Whole<CountingMethod>>(subject);
  return std::make_unique<Whole<UncountedMethod>>(subject);
}

}  // namespace csgsim::software
