#include "sim/session/model/primitive_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

#include "hw/base/nearest.h"
#include "hw/isa/facts.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

namespace {

/// Parses an index; nothing if the text is not one. An index out of range yields no_primitive.
std::optional<std::uint32_t> parse_index(std::string_view text) {
  if (text.starts_with('p')) text.remove_prefix(1);
  if (text.empty() || !std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  std::uint32_t index = isa::no_primitive;
  std::from_chars(text.data(), text.data() + text.size(), index);
  return index;
}

/// Whether the name, up to its column, begins with the text.
bool is_on_line(std::string_view name, std::string_view text) {
  const std::size_t at = text.find('@');
  if (at == std::string_view::npos) return false;
  const std::string_view place = at == 0 ? name.substr(std::min(name.find('@'), name.size())) : name;
  return place.starts_with(text) && place.substr(text.size()).starts_with(':');
}

template <class Is>
std::vector<std::uint32_t> matching(const std::vector<std::string>& names, Is is) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < names.size(); ++i)
    if (is(names[i])) all.push_back(i);
  return all;
}

[[noreturn]] void refuse_several(const std::vector<std::string>& names, const std::vector<std::uint32_t>& meant,
                                 const std::string& text, const std::string& option) {
  std::string list;
  for (const std::uint32_t i : meant) list += fmt::format("{}p{} {}", list.empty() ? "" : ", ", i, names[i]);
  throw UsageError(option, fmt::format("'{}' is ambiguous: {}; give the index", text, list));
}

[[noreturn]] void refuse(const std::vector<std::string>& names, const std::string& text, const std::string& option) {
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string_view near = nearest(text, candidates);
  throw UsageError(option, fmt::format("there is no primitive '{}'{}; name one by index (p0), by name or by line "
                                       "(@9)",
                                       text, near.empty() ? "" : fmt::format(", the nearest is '{}'", near)));
}

}  // namespace

std::uint32_t parse_primitive(const isa::Program& program, const std::string& text, const std::string& option) {
  const std::vector<std::string>& names = program.facts->primitives;
  if (const std::optional<std::uint32_t> index = parse_index(text)) {
    if (*index < names.size()) return *index;
    throw UsageError(
        option,
        fmt::format("there is no primitive {}: the Program has {}, counted from 0; for a line of the model, write @{}",
                    text, names.size(), text.substr(text.starts_with('p') ? 1 : 0)));
  }
  std::vector<std::uint32_t> meant = matching(names, [&](const std::string& name) { return name == text; });
  if (meant.empty()) meant = matching(names, [&](const std::string& name) { return is_on_line(name, text); });
  if (meant.empty()) refuse(names, text, option);
  if (meant.size() > 1) refuse_several(names, meant, text, option);
  return meant.front();
}

Pixel parse_pixel(const isa::Program& program, const std::string& text, const std::string& option) {
  const auto place = numbers<std::uint32_t>(text, ',', 2, option, "x,y");
  if (place[0] < program.shape.width && place[1] < program.shape.height) return {place[0], place[1]};
  throw UsageError(option, fmt::format("there is no pixel {} in a picture of {} x {}", text, program.shape.width,
                                       program.shape.height));
}

}  // namespace csgsim::session
