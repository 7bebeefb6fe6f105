// The exception for wrong parameter changes.
// Used by hw/machines and by callers that change parameters.
#pragma once

#include "hw/base/error.h"

namespace csgsim::machines {

/// A requested change of a parameter is wrong, while the description itself is valid.
class ChangeError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace csgsim::machines
