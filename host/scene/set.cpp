#include "host/scene/set.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "host/scene/read.h"
#include "hw/base/text.h"
#include "hw/base/toml_text.h"

namespace csgsim::scene {

namespace {

constexpr std::size_t max_parts = 8;  ///< maximum number of parts of a key

class Setter {
 public:
  explicit Setter(const std::string& text) : text_(text), source_(std::string(set_mark) + printable(text)) {}

  void into(toml::table& root) {
    const std::size_t equals = text_.find('=');
    if (equals == text_.npos) fail("write KEY=VALUE, as in lights.0.direction=0,0,-1");
    const std::vector<std::string_view> parts = split_key(std::string_view(text_).substr(0, equals));
    toml::node* node = &root;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) node = &step(*node, parts[i], is_index(parts[i + 1]));
    put(*node, parts.back(), parse_value(text_.substr(equals + 1)));
  }

 private:
  [[noreturn]] void fail(std::string_view message) const { throw SetError(fmt::format("{}: {}", source_, message)); }

  /// Rejects a key with `part` below a node that has no keys.
  [[noreturn]] void fail_below(const toml::node& node, std::string_view part) const {
    if (node.is_array()) fail(fmt::format("'{}' is below a list; set the whole list, or a key of a table in it", part));
    fail(fmt::format("'{}' is below {}, which has no keys; remove '.{}'", part, type_name(node), part));
  }

  [[nodiscard]] std::vector<std::string_view> split_key(std::string_view key) const {
    std::vector<std::string_view> parts;
    while (true) {
      const std::size_t dot = key.find('.');
      parts.push_back(key.substr(0, dot));
      if (parts.back().empty()) fail("the key has an empty part; write words and numbers separated by single dots");
      if (parts.size() > max_parts) fail(fmt::format("the key has more than {} parts; shorten it", max_parts));
      if (dot == key.npos) return parts;
      key.remove_prefix(dot + 1);
    }
  }

  static bool is_index(std::string_view part) {
    return std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  }

  [[nodiscard]] std::size_t parse_index(std::string_view part, const toml::array& list) const {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    if (error != std::errc() || end != part.data() + part.size() || index > list.size()) {
      fail(fmt::format("'{}' is not an index of a list of {}; count from 0, {} adds an element", part, list.size(),
                       list.size()));
    }
    return index;
  }

  /// The table or list at `part` below a node; it is created if it does not exist.
  toml::node& step(toml::node& node, std::string_view part, bool holds_list) const {
    if (toml::array* const list = node.as_array()) {
      const std::size_t index = parse_index(part, *list);
      if (index == list->size()) list->push_back(toml::table{});
      return *list->get(index);
    }
    toml::table* const table = node.as_table();
    if (table == nullptr) fail_below(node, part);
    if (!table->contains(part)) {
      if (holds_list) {
        table->insert(part, toml::array{});
      } else {
        table->insert(part, toml::table{});
      }
    }
    return *table->get(part);
  }

  void put(toml::node& node, std::string_view part, toml::table&& holder) const {
    toml::table* const table = node.as_table();
    if (table == nullptr) fail_below(node, part);
    holder.get("value")->visit([&](auto& typed) { table->insert_or_assign(part, std::move(typed)); });
  }

  /// Parses the value into a table. Lists of numbers need no brackets, and words need no quotes.
  [[nodiscard]] toml::table parse_value(const std::string& text) const {
    if (text.find('\n') != text.npos) fail("the value must be on one line");
    for (const std::string& form : {"value = " + text, "value = [" + text + "]", "value = '" + text + "'"}) {
      try {
        toml::table holder = parse_toml(form, source_);
        if (holder.size() == 1) return holder;
      } catch (const InputError&) {
        // try the next form
      }
    }
    fail("the value must be a number, true, false, numbers separated by commas, or a word");
  }

  const std::string& text_;
  std::string source_;
};

}  // namespace

void set(toml::table& root, const std::string& key_and_value) { Setter(key_and_value).into(root); }

}  // namespace csgsim::scene
