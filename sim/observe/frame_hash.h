#pragma once

#include <string>
#include <vector>

#include "hw/base/hash.h"
#include "sim/observe/frame.h"

namespace csgsim::observe {

/// Of depth, owner and colour of every pixel.
inline std::string hash_of(const observe::Frame& frame) {
  Hash hash;
  for (const std::vector<std::uint32_t>* values : {&frame.depth, &frame.owner, &frame.colour}) hash.add(*values);
  return hash.text();
}

/// Of depth and owner alone.
inline std::string hash_of_surfaces(const observe::Frame& frame) {
  Hash hash;
  for (const std::vector<std::uint32_t>* values : {&frame.depth, &frame.owner}) hash.add(*values);
  return hash.text();
}

}  // namespace csgsim::observe
