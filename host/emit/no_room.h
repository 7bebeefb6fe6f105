// The error for pictures that do not fit pixel memory.
// Thrown by the layout and caught by sessions.
#pragma once

#include <string_view>

#include "hw/base/error.h"

namespace csgsim::emit {

/// Pixel memory is too small for a picture.
class OutOfPixelMemory : public InputError {
 public:
  OutOfPixelMemory(std::string_view message, unsigned needed_bits) : InputError(message), needed(needed_bits) {}

  unsigned needed;  ///< required bits per pixel
};

}  // namespace csgsim::emit
