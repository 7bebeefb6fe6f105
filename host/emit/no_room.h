#pragma once

#include <string_view>

#include "hw/base/error.h"

namespace csgsim::emit {

/// Pixel memory does not hold what a picture needs.
class NoRoom : public InputError {
 public:
  NoRoom(std::string_view message, unsigned needed_bits) : InputError(message), needed(needed_bits) {}

  unsigned needed;  ///< bits a pixel
};

}  // namespace csgsim::emit
