#include "hw/base/error.h"

#include "hw/base/text.h"

namespace csgsim {

InputError::InputError(std::string_view message) : std::runtime_error(printable(message)) {}

}  // namespace csgsim
