#include "sim/rtl/template.h"

#include <algorithm>
#include <stdexcept>

namespace csgsim::rtl {

namespace {

constexpr std::string_view name_characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ_";

const std::string& value_of(std::string_view name, std::span<const Filling> fillings) {
  const auto found = std::ranges::find(fillings, name, &Filling::name);
  if (found == fillings.end()) throw std::logic_error("a template's @" + std::string(name) + "@ has no value");
  return found->value;
}

}  // namespace

std::string fill_template(std::string_view text, std::span<const Filling> fillings) {
  std::string out;
  while (true) {
    const std::size_t mark = text.find('@');
    out += text.substr(0, mark);
    if (mark == std::string_view::npos) return out;
    const std::size_t end = text.find_first_not_of(name_characters, mark + 1);
    const bool is_name = end != std::string_view::npos && end > mark + 1 && text[end] == '@';
    if (!is_name) {  // as in `always @(posedge clk)`
      out += '@';
      text.remove_prefix(mark + 1);
      continue;
    }
    out += value_of(text.substr(mark + 1, end - mark - 1), fillings);
    text.remove_prefix(end + 1);
  }
}

}  // namespace csgsim::rtl
