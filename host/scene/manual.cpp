#include "host/scene/manual.h"

#include <fmt/format.h>

#include <cstddef>
#include <variant>

namespace csgsim::scene {

namespace {

std::string range_text(const Key& key, std::string_view what) {
  if (key.most >= coordinate_limit) return std::string(what);
  return fmt::format("{}, {:g} to {:g}", what, key.least, key.most);
}

struct ShowValue {
  const Key& key;

  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(double value) const { return fmt::format("{:g}", value); }
  std::string operator()(std::int64_t value) const {
    return key.kind == ValueKind::choice ? std::string(key.names[static_cast<std::size_t>(value)])
                                         : fmt::format("{}", value);
  }
  std::string operator()(const ColourTable& /*value*/) const { return ""; }
  std::string operator()(const glm::dvec3& value) const {
    return fmt::format("[{:g}, {:g}, {:g}]", value.x, value.y, value.z);
  }
};

}  // namespace

std::string allowed_text(const Key& key) {
  switch (key.kind) {
    case ValueKind::boolean: return "`true`, `false`";
    case ValueKind::integer: return range_text(key, "integer");
    case ValueKind::number: return range_text(key, "number");
    case ValueKind::vector: return "[x, y, z]";
    case ValueKind::colour: return "[red, green, blue], each 0 to 1";
    case ValueKind::colour_table: return "[[[red, green, blue], ...], ...]";
    case ValueKind::choice: return fmt::format("`{}`", fmt::join(key.names, "`, `"));
  }
  return {};
}

std::string value_text(const KeyValue& value) {
  return value.value ? std::visit(ShowValue{value.key}, *value.value) : "";
}

std::string keys_table(const Section& section) {
  const Values blank = section.blank();
  if (blank.empty()) return "";
  std::string table = "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const KeyValue& one : blank) {
    const std::string unit = one.key.unit.empty() ? "" : fmt::format(" ({})", one.key.unit);
    table += fmt::format("| `{}` | {}{} | {} | {} |\n", one.key.name, allowed_text(one.key), unit, value_text(one),
                         one.key.meaning);
  }
  return table;
}

}  // namespace csgsim::scene
