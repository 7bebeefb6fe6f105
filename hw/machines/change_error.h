#pragma once

#include "hw/base/error.h"

namespace csgsim::machines {

/// What is wrong with a change of a figure that was asked for, where the description itself is right.
class ChangeError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace csgsim::machines
