// Hashes of a picture.
// Used by sim/session and sim/studies.
#pragma once

#include <string>
#include <utility>

#include "hw/base/hash.h"
#include "sim/observe/frame.h"

namespace csgsim::observe {

struct FrameHashes {
  std::string surfaces;  ///< hash of depth and owner of every pixel
  std::string picture;   ///< hash of depth, owner and colour of every pixel
};

inline FrameHashes hashes_of(const Frame& frame) {
  Hash hash;
  hash.add(frame.depth);
  hash.add(frame.owner);
  std::string surfaces = hash.text();
  hash.add(frame.colour);
  return {std::move(surfaces), hash.text()};
}

/// Hash of depth, owner and colour of every pixel.
inline std::string hash_of(const Frame& frame) { return hashes_of(frame).picture; }

}  // namespace csgsim::observe
