#include "hw/systemc/wave_request.h"

#include <algorithm>
#include <cctype>

namespace csgsim::kernel {

std::string wave_identifier(std::string_view name) {
  std::string result(name);
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return result;
}

}  // namespace csgsim::kernel
