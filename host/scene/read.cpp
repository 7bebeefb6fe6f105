#include "host/scene/read.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "host/scene/set.h"
#include "hw/base/nearest.h"
#include "hw/base/toml_text.h"

namespace csgsim::scene {

namespace {

constexpr std::string_view effects_prefix = "effects.";
constexpr std::string_view on_key = "on";  ///< key of every effect
constexpr std::size_t max_in_list = 1000;  ///< maximum number of tables or colours in a list

bool is_set(const toml::node& node) {
  const toml::source_region& place = node.source();
  return place.path && place.path->starts_with(set_mark);
}

/// The first value in the node that was set by KEY=VALUE instead of the file; null if there is none.
const toml::node* set_value(const toml::node& node) {
  if (is_set(node)) return &node;
  const toml::node* found = nullptr;
  const auto look = [&](const toml::node& inner) {
    if (found == nullptr) found = set_value(inner);
  };
  if (const toml::table* const table = node.as_table())
    for (const auto& [key, inner] : *table) look(inner);
  if (const toml::array* const list = node.as_array())
    for (const toml::node& inner : *list) look(inner);
  return found;
}

std::string unknown_key(std::string_view key, std::span<const std::string_view> known, std::string_view prefix) {
  const std::string_view near = nearest_similar(key, known);
  return fmt::format("unknown key '{}{}'; {}", prefix, key,
                     near.empty() ? fmt::format("the keys here are {}", fmt::join(known, ", "))
                                  : fmt::format("the nearest known is '{}{}'", prefix, near));
}

class Reader {
 public:
  Reader(std::string_view file, std::span<const Section> effects, std::vector<SectionValues>* values)
      : file_(file), effects_(effects), values_(values) {}

  Scene read(const toml::table& root) {
    std::vector<std::string_view> known{"effects"};
    for (const Section& section : common_sections()) known.push_back(section.name);
    check_keys(root, known, "");
    for (const Section& section : common_sections()) read_if_present(root, section, section.name);
    const toml::node* const effects = root.get("effects");
    if (effects != nullptr) read_effects(require_table(*effects, "effects", "NAME.on"));
    return std::move(scene_);
  }

 private:
  [[noreturn]] void fail(const toml::node& at, std::string_view message) const {
    if (is_set(at)) throw SetError(fmt::format("{}: {}", *at.source().path, message));
    throw InputError(fmt::format("{}: {}", position_text(at.source().begin, file_), message));
  }

  /// `key` is a key of the table, for messages.
  const toml::table& require_table(const toml::node& node, std::string_view name, std::string_view key) const {
    const toml::table* const table = node.as_table();
    if (table != nullptr) return *table;
    if (is_set(node)) fail(node, fmt::format("'{0}' is a group of keys; name one of them, as in {0}.{1}", name, key));
    fail(node, fmt::format("'{0}' is {1}; make it a table [{0}]", name, type_name(node)));
  }

  void check_keys(const toml::table& table, std::span<const std::string_view> known, std::string_view prefix) const {
    for (const auto& [key, node] : table) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      const std::string message = prefix == effects_prefix ? unknown_name_text("effect", key.str(), known)
                                                           : unknown_key(key.str(), known, prefix);
      if (const toml::node* const value = set_value(node)) fail(*value, message);
      throw InputError(fmt::format("{}: {}", position_text(key.source().begin, file_), message));
    }
  }

  void read_effects(const toml::table& table) {
    std::vector<std::string_view> known;
    for (const Section& effect : effects_) known.push_back(effect.name.substr(effects_prefix.size()));
    check_keys(table, known, effects_prefix);
    for (const Section& effect : effects_) read_if_present(table, effect, effect.name.substr(effects_prefix.size()));
  }

  /// Whether the effect's table switches it on, which is the default.
  [[nodiscard]] bool is_on(const toml::table& table, const Section& section) const {
    const toml::node* const node = table.get(on_key);
    return node == nullptr || read_boolean(*node, fmt::format("{}.{}", section.name, on_key));
  }

  void read_if_present(const toml::table& table, const Section& section, std::string_view key) {
    const toml::node* const node = table.get(key);
    if (node == nullptr) {
      const bool always_holds = !section.is_list && !section.name.starts_with(effects_prefix);
      if (always_holds) report_values(section, section.blank());
      return;
    }
    const std::string_view example =
        section.name.starts_with(effects_prefix) ? on_key : section.blank().front().key.name;
    if (!section.is_list) return read_section(require_table(*node, section.name, example), section);
    const toml::array* const list = node->as_array();
    if (list == nullptr) {
      if (const toml::node* const value = set_value(*node))
        fail(*value,
             fmt::format("'{0}' is a list; number its elements from 0, as in {0}.0.{1}", section.name, example));
      fail(*node, fmt::format("'{0}' is {1}; make it a list of tables, [[{0}]] each", section.name, type_name(*node)));
    }
    if (list->size() > max_in_list) {
      fail(*node, fmt::format("{} has more than {} tables; remove some", section.name, max_in_list));
    }
    for (const toml::node& one : *list) {
      const toml::table* const entry = one.as_table();
      if (entry == nullptr) {
        fail(one, fmt::format("'{0}' contains {1}; make it a table, [[{0}]]", section.name, type_name(one)));
      }
      read_section(*entry, section);
    }
  }

  void read_section(const toml::table& table, const Section& section) {
    std::vector<std::string_view> known;
    Values read = section.blank();
    for (const KeyValue& one : read) known.push_back(one.key.name);
    const bool is_effect = section.name.starts_with(effects_prefix);
    if (is_effect) known.push_back(on_key);
    check_keys(table, known, fmt::format("{}.", section.name));
    for (auto& [key, value] : read) {
      const toml::node* const node = table.get(key.name);
      if (node != nullptr) value = read_value(*node, key, fmt::format("{}.{}", section.name, key.name));
    }
    const bool is_requested = !is_effect || is_on(table, section);
    if (is_requested) report_values(section, read);
    if (section.is_list && !is_requested) return;  // another table of the list may be on
    try {
      section.keep(scene_, section, std::move(read));
    } catch (const InputError& error) {
      fail(table, error.what());
    }
    if (is_effect && !is_on(table, section)) scene_.effects.back().is_on = false;
  }

  void report_values(const Section& section, const Values& read) const {
    if (values_ != nullptr) values_->push_back({section.name, section.is_list, read});
  }

  [[nodiscard]] Value read_value(const toml::node& node, const Key& key, const std::string& name) const {
    switch (key.kind) {
      case ValueKind::boolean: return read_boolean(node, name);
      case ValueKind::integer: return read_integer(node, key, name);
      case ValueKind::number: return read_number(node, key, name);
      case ValueKind::vector:
      case ValueKind::colour: return read_vector(node, key, name);
      case ValueKind::colour_table: return read_colour_table(node, key, name);
      case ValueKind::choice: break;
    }
    return read_choice(node, key, name);
  }

  [[nodiscard]] bool read_boolean(const toml::node& node, const std::string& name) const {
    const toml::value<bool>* const value = node.as_boolean();
    if (value == nullptr) fail(node, fmt::format("{} is {}; make it true or false", name, type_name(node)));
    return value->get();
  }

  [[nodiscard]] std::int64_t read_integer(const toml::node& node, const Key& key, const std::string& name) const {
    const toml::value<std::int64_t>* const value = node.as_integer();
    if (value == nullptr) fail(node, fmt::format("{} is {}; make it an integer", name, type_name(node)));
    check_range(node, static_cast<double>(value->get()), key, name);
    return value->get();
  }

  [[nodiscard]] double read_number(const toml::node& node, const Key& key, const std::string& name) const {
    if (!node.is_number()) fail(node, fmt::format("{} is {}; make it a number", name, type_name(node)));
    const double value = *node.value<double>();
    check_range(node, value, key, name);
    return value;
  }

  [[nodiscard]] glm::dvec3 read_vector(const toml::node& node, const Key& key, const std::string& name) const {
    const toml::array* const list = node.as_array();
    if (list == nullptr || list->size() != 3) {
      const std::string_view form = key.kind == ValueKind::vector ? "[x, y, z]" : "[red, green, blue]";
      fail(node, fmt::format("{} is {}; make it {}", name,
                             list == nullptr ? std::string(type_name(node)) : fmt::format("a list of {}", list->size()),
                             form));
    }
    glm::dvec3 value;
    for (int i = 0; i < 3; ++i) value[i] = read_number(*list->get(static_cast<std::size_t>(i)), key, name);
    return value;
  }

  [[nodiscard]] ColourTable read_colour_table(const toml::node& node, const Key& key, const std::string& name) const {
    const toml::array* const rows = node.as_array();
    if (rows == nullptr || rows->empty() || rows->size() > max_in_list) fail_table(node, name);
    ColourTable table;
    for (const toml::node& row : *rows) {
      const toml::array* const colours = row.as_array();
      if (colours == nullptr || colours->empty() || colours->size() > max_in_list) fail_table(row, name);
      table.emplace_back();
      for (const toml::node& one : *colours) table.back().push_back(read_vector(one, key, "a colour of " + name));
      if (table.back().size() != table.front().size()) {
        fail(row, fmt::format("{} has a row of {} colours after one of {}; make its rows equally long", name,
                              table.back().size(), table.front().size()));
      }
    }
    return table;
  }

  [[noreturn]] void fail_table(const toml::node& node, const std::string& name) const {
    fail(node,
         fmt::format("{} is not a list of rows; make it [[[red, green, blue], ...], ...], with 1 to {} colours in a "
                     "row",
                     name, max_in_list));
  }

  [[nodiscard]] std::int64_t read_choice(const toml::node& node, const Key& key, const std::string& name) const {
    const toml::value<std::string>* const text = node.as_string();
    const std::string given = text == nullptr ? std::string(type_name(node)) : fmt::format("'{}'", text->get());
    const auto found = text == nullptr ? key.names.end()
                                       : std::find(key.names.begin(), key.names.end(), std::string_view(text->get()));
    if (found == key.names.end()) {
      const std::string_view near = text == nullptr ? std::string_view() : nearest_similar(text->get(), key.names);
      fail(node, fmt::format("{} is {};{} it must be one of {}", name, given,
                             near.empty() ? "" : fmt::format(" did you mean {}?", near), fmt::join(key.names, ", ")));
    }
    return found - key.names.begin();
  }

  void check_range(const toml::node& node, double value, const Key& key, const std::string& name) const {
    if (value >= key.least && value <= key.most) return;
    fail(node, fmt::format("{} is {}; it must be {} to {}{}{}", name, value, key.least, key.most,
                           key.unit.empty() ? "" : " ", key.unit));
  }

  std::string_view file_;
  std::span<const Section> effects_;
  std::vector<SectionValues>* values_;
  Scene scene_;
};

}  // namespace

Scene read_scene(std::string_view text, std::string_view file, std::span<const std::string> assignments,
                 std::span<const Section> effects, std::vector<SectionValues>* values) {
  toml::table root = parse_toml(text, file);
  for (const std::string& one : assignments) set(root, one);
  return Reader(file, effects, values).read(root);
}

}  // namespace csgsim::scene
