#include "sim/suite/suite.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/toml_text.h"

namespace csgsim::suite {

namespace {

/// Every option of csgsim compile that changes a Program, except --machine. Scenes, tolerances and near planes are
/// never given.
constexpr auto setting_keys = std::to_array<std::string_view>(
    {"size", "camera", "projection", "memory-bits", "strategy", "stack-bits", "colouring", "colour-bits",
     "colour-scheme", "curves", "pruning", "z-bits", "fraction-bits", "edge-on"});
constexpr auto root_keys = std::to_array<std::string_view>({"version", "stored", "compiled", "settings", "case"});
constexpr auto own_keys = std::to_array<std::string_view>({"name", "group", "about", "model"});

bool is_name(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

class ListReader {
 public:
  explicit ListReader(std::string_view file) : file_(file) {}

  Suite read(const toml::table& root) {
    check_keys(root, root_keys);
    Suite suite;
    suite.version = text_of(require(root, "version"), "version");
    suite.stored = texts_of(require(root, "stored"), "stored");
    suite.compiled = texts_of(require(root, "compiled"), "compiled");
    const toml::node& cases = require(root, "case");
    if (!cases.is_array_of_tables()) fail(cases, "'case' must be a list of tables; begin each case with [[case]]");
    for (const toml::node& one : *cases.as_array()) suite.cases.push_back(read_case(*one.as_table(), root, suite));
    return suite;
  }

 private:
  [[noreturn]] void fail(const toml::node& at, std::string_view message) const {
    throw InputError(fmt::format("{}: {}", position_text(at.source().begin, file_), message));
  }

  template <class Keys>
  void check_keys(const toml::table& table, const Keys& known) const {
    for (const auto& [key, node] : table) {
      if (std::ranges::find(known, key.str()) == known.end())
        throw InputError(fmt::format("{}: {}", position_text(key.source().begin, file_),
                                     unknown_name_text("key", key.str(), std::span<const std::string_view>(known))));
    }
  }

  [[nodiscard]] const toml::node& require(const toml::table& table, std::string_view key) const {
    const toml::node* const node = table.get(key);
    if (node == nullptr) fail(table, fmt::format("'{}' is missing; add it", key));
    return *node;
  }

  /// Numbers are taken as texts, because an option's value is one.
  [[nodiscard]] std::string text_of(const toml::node& node, std::string_view key) const {
    if (const auto text = node.value_exact<std::string>(); text && !text->empty()) return *text;
    if (const auto number = node.value_exact<std::int64_t>()) return std::to_string(*number);
    if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
    fail(node, fmt::format("'{}' is {}; write a text that is not empty, or a number", key,
                           node.is_string() ? "an empty string" : type_name(node)));
  }

  [[nodiscard]] std::vector<std::string> texts_of(const toml::node& node, std::string_view key) const {
    const toml::array* const list = node.as_array();
    if (list == nullptr) fail(node, fmt::format("'{}' is {}; write a list of names", key, type_name(node)));
    std::vector<std::string> texts;
    for (const toml::node& one : *list) texts.push_back(text_of(one, key));
    return texts;
  }

  [[nodiscard]] const toml::table& common_settings(const toml::table& root) const {
    const toml::node& node = require(root, "settings");
    const toml::table* const table = node.as_table();
    if (table == nullptr) fail(node, fmt::format("'settings' is {}; make it a table [settings]", type_name(node)));
    check_keys(*table, setting_keys);
    return *table;
  }

  [[nodiscard]] Case read_case(const toml::table& table, const toml::table& root, const Suite& suite) const {
    const toml::table& common = common_settings(root);
    std::vector<std::string_view> known(own_keys.begin(), own_keys.end());
    known.insert(known.end(), setting_keys.begin(), setting_keys.end());
    check_keys(table, known);
    Case one;
    const toml::node& name = require(table, "name");
    one.name = text_of(name, "name");
    if (!is_name(one.name))
      fail(name, fmt::format("the name '{}' must consist of letters, digits and _, because files are named after it",
                             one.name));
    if (std::ranges::find(suite.cases, one.name, &Case::name) != suite.cases.end())
      fail(name, fmt::format("there are two cases '{}'; rename one", one.name));
    one.group = text_of(require(table, "group"), "group");
    one.about = text_of(require(table, "about"), "about");
    one.model = text_of(require(table, "model"), "model");
    for (const std::string_view key : setting_keys) {
      const toml::node* node = table.get(key);
      if (node == nullptr) node = common.get(key);
      if (node == nullptr)
        fail(table, fmt::format("'{}' is missing; set it here or in [settings]: every setting is explicit", key));
      one.settings.emplace_back(key, text_of(*node, key));
    }
    return one;
  }

  std::string_view file_;
};

}  // namespace

Suite read_suite(std::string_view text, std::string_view file) { return ListReader(file).read(parse_toml(text, file)); }

const Case& case_named(const Suite& suite, std::string_view name) {
  const auto found = std::ranges::find(suite.cases, name, &Case::name);
  if (found == suite.cases.end()) throw InputError(unknown_name_text("case", name, case_names(suite)));
  return *found;
}

std::vector<std::string> case_names(const Suite& suite) {
  std::vector<std::string> names;
  for (const Case& one : suite.cases) names.push_back(one.name);
  return names;
}

}  // namespace csgsim::suite
