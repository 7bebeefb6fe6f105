// The exception for inconsistent parameters.
// Used by hw/machines and hw/bit_serial_memory.
#pragma once

#include <string>
#include <string_view>

#include "hw/base/error.h"

namespace csgsim::machines {

/// Thrown if a parameter is not consistent with other parameters of its machine.
class FigureError : public InputError {
 public:
  FigureError(std::string_view key, std::string_view message) : InputError(message), key_(key) {}

  [[nodiscard]] const std::string& key() const { return key_; }

 private:
  std::string key_;
};

}  // namespace csgsim::machines
