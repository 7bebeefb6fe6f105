#include <fmt/format.h>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/text.h"

namespace csgsim {

void check_length(std::string_view name, std::size_t byte_count, const InputKind& kind) {
  if (byte_count <= kind.max_bytes) return;
  throw InputError(fmt::format("{}: longer than {}; {}", name, binary_size(kind.max_bytes), kind.advice));
}

}  // namespace csgsim
