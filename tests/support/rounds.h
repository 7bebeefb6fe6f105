#pragma once

#include <rapidcheck.h>

namespace csgsim::testing {

/// Takes a number off the random stream for each round before. Properties that are checked several times in a process
/// all begin with the same numbers: without this they draw the same cases again.
inline void begin_round(int round) {
  for (int i = 0; i < round; ++i) static_cast<void>(*rc::gen::arbitrary<bool>());
}

}  // namespace csgsim::testing
