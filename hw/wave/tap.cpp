#include "hw/wave/tap.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace csgsim::wave {

void add(std::vector<Tap> more, std::vector<Tap>& taps) {
  taps.insert(taps.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::string identifier(std::string_view name) {
  std::string result(name);
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return result;
}

}  // namespace csgsim::wave
