#include "sim/shell/settings/settings_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "hw/base/toml_text.h"
#include "sim/session/options/option_table.h"

namespace csgsim::shell {

namespace {

const SettableOption* find(std::span<const SettableOption> options, std::string_view name) {
  const auto found = std::ranges::find(options, name, &SettableOption::name);
  return found == options.end() ? nullptr : &*found;
}

class Reader {
 public:
  Reader(const std::string& file, std::span<const SettableCommand> commands, std::string_view command)
      : shown_(printable(file)),
        folder_(std::filesystem::path(file).parent_path().native()),
        commands_(commands),
        command_(command) {}

  std::vector<Setting> read(const toml::table& root) {
    for (const auto& [key, node] : root) {
      const SettableCommand* const command = command_named(key.str());
      // Some commands have the same name as an option of another command.
      if (command != nullptr && (node.is_table() || !is_option(key.str()))) {
        read_command(*command, key, node);
      } else {
        read_common(key, node);
      }
    }
    // The table does not keep the order of the file; restore it.
    std::ranges::sort(found_, {}, [](const Found& one) { return std::pair(one.place.line, one.place.column); });
    std::vector<Setting> settings;
    for (Found& one : found_) {
      if (!is_overridden(one)) settings.push_back(std::move(one.setting));
    }
    return settings;
  }

 private:
  struct Found {
    Setting setting;
    toml::source_position place;
    bool is_own;  ///< the setting is in the command's own table
  };

  [[noreturn]] void fail(const toml::source_position& place, std::string_view message) const {
    throw InputError(fmt::format("{}: {}", position_text(place, shown_), message));
  }

  [[nodiscard]] const SettableCommand* command_named(std::string_view name) const {
    const auto found = std::ranges::find(commands_, name, &SettableCommand::name);
    return found == commands_.end() ? nullptr : &*found;
  }

  [[nodiscard]] bool is_option(std::string_view name) const {
    return std::ranges::any_of(commands_,
                               [&](const SettableCommand& command) { return find(command.options, name) != nullptr; });
  }

  /// Whether the command's table also sets the option.
  [[nodiscard]] bool is_overridden(const Found& one) const {
    return !one.is_own && std::ranges::any_of(found_, [&](const Found& other) {
      return other.is_own && other.setting.name == one.setting.name;
    });
  }

  void read_command(const SettableCommand& command, const toml::key& key, const toml::node& node) {
    const toml::table* const table = node.as_table();
    if (table == nullptr)
      fail(key.source().begin, fmt::format("'{0}' is {1}; make it a table, [{0}]", command.name, type_name(node)));
    for (const auto& [name, value] : *table) {
      const SettableOption* const option = find(command.options, name.str());
      if (option == nullptr) fail_unknown(name, command.options, command.name);
      keep(*option, name, value, command.name == command_);
    }
  }

  /// The command's own option of that name defines the type; if it has none, an option of another command does.
  void read_common(const toml::key& key, const toml::node& node) {
    std::vector<const SettableOption*> of_others;
    for (const SettableCommand& command : commands_) {
      const SettableOption* const option = find(command.options, key.str());
      if (option == nullptr) continue;
      if (command.name == command_) return keep(*option, key, node, true, false);
      of_others.push_back(option);
    }
    if (of_others.empty()) fail_unknown(key, vocabulary(), "any command");
    const bool suits = std::ranges::any_of(
        of_others, [&](const SettableOption* option) { return option != of_others.back() && takes(*option, node); });
    if (!suits) keep(*of_others.back(), key, node, false);
  }

  [[nodiscard]] bool takes(const SettableOption& option, const toml::node& node) const {
    try {
      static_cast<void>(values_of(option, node));
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  /// Every key allowed at the top level.
  [[nodiscard]] std::vector<SettableOption> vocabulary() const {
    std::vector<SettableOption> all;
    for (const SettableCommand& command : commands_) {
      all.push_back({command.name});
      all.insert(all.end(), command.options.begin(), command.options.end());
    }
    return all;
  }

  [[noreturn]] void fail_unknown(const toml::key& key, std::span<const SettableOption> options,
                                 std::string_view whose) const {
    std::vector<std::string_view> known;
    for (const SettableOption& option : options) known.push_back(option.name);
    fail(key.source().begin, fmt::format("'{}' is not an option of {}; the nearest known is '{}'", printable(key.str()),
                                         whose, nearest(key.str(), known)));
  }

  void keep(const SettableOption& option, const toml::key& key, const toml::node& node, bool is_wanted,
            bool is_own = true) {
    Setting setting{option.name, values_of(option, node), position_text(key.source().begin, shown_)};
    if (is_wanted) found_.push_back({std::move(setting), key.source().begin, is_own});
  }

  [[nodiscard]] std::vector<std::string> values_of(const SettableOption& option, const toml::node& node) const {
    switch (option.takes) {
      case Takes::flag: return {flag_of(option, node)};
      case Takes::whole_number: return {whole_number_of(option, node)};
      case Takes::number: return {number_of(option, node)};
      case Takes::text: return {text_of(option, node)};
      case Takes::texts: break;
    }
    return texts_of(option, node);
  }

  [[noreturn]] void fail_type(const SettableOption& option, const toml::node& node, std::string_view wanted) const {
    fail(node.source().begin, fmt::format("{} is {}; make it {}", option.name, type_name(node), wanted));
  }

  [[nodiscard]] std::string flag_of(const SettableOption& option, const toml::node& node) const {
    const toml::value<bool>* const value = node.as_boolean();
    if (value == nullptr) fail_type(option, node, "true or false");
    return value->get() ? "true" : "false";
  }

  [[nodiscard]] std::string whole_number_of(const SettableOption& option, const toml::node& node) const {
    const toml::value<std::int64_t>* const value = node.as_integer();
    if (value == nullptr) fail_type(option, node, "an integer");
    if (value->get() < 0)
      fail(node.source().begin, fmt::format("{} is {}; make it 0 or more", option.name, value->get()));
    return fmt::format("{}", value->get());
  }

  [[nodiscard]] std::string number_of(const SettableOption& option, const toml::node& node) const {
    if (const toml::value<std::int64_t>* const value = node.as_integer()) return fmt::format("{}", value->get());
    const toml::value<double>* const value = node.as_floating_point();
    if (value == nullptr) fail_type(option, node, "a number");
    if (!std::isfinite(value->get())) fail(node.source().begin, option.name + " is not finite; make it a number");
    return fmt::format("{}", value->get());
  }

  /// The text of a single value, or of one element of a list. `wanted` describes the valid types in the message.
  [[nodiscard]] std::string word_of(const SettableOption& option, const toml::node& node,
                                    std::string_view wanted) const {
    if (node.is_number()) return number_of(option, node);
    const toml::value<std::string>* const value = node.as_string();
    if (value == nullptr) fail_type(option, node, wanted);
    if (value->get().find('\0') != std::string::npos)
      fail(node.source().begin, option.name + " contains a zero byte, which a command line cannot hold; remove it");
    return resolve_in_folder(option.name, value->get(), folder_);
  }

  /// A list becomes a comma-separated text, except for file names, which are single values.
  [[nodiscard]] std::string text_of(const SettableOption& option, const toml::node& node) const {
    const FileRole role = known_option(option.name).role;
    const bool is_file = role == FileRole::input || role == FileRole::output;
    const std::string_view wanted = is_file ? "a string" : "a string, a number, or a list of them";
    const toml::array* const list = node.as_array();
    if (list == nullptr) return word_of(option, node, wanted);
    if (is_file) fail_type(option, node, wanted);
    check_length(option, *list);
    std::string text;
    for (const toml::node& one : *list) {
      if (!text.empty()) text += ',';
      text += word_of(option, one, "a string or a number");
    }
    return text;
  }

  [[nodiscard]] std::vector<std::string> texts_of(const SettableOption& option, const toml::node& node) const {
    const toml::array* const list = node.as_array();
    if (list == nullptr) return {word_of(option, node, "a string, or a list of strings")};
    check_length(option, *list);
    std::vector<std::string> texts;
    for (const toml::node& one : *list) texts.push_back(word_of(option, one, "a string"));
    return texts;
  }

  void check_length(const SettableOption& option, const toml::array& list) const {
    if (list.size() > max_list_values)
      fail(list.source().begin, fmt::format("{} has more than {} values; give fewer", option.name, max_list_values));
  }

  std::string shown_;
  std::string folder_;
  std::span<const SettableCommand> commands_;
  std::string_view command_;
  std::vector<Found> found_;
};

}  // namespace

std::vector<Setting> read_settings(std::string_view text, const std::string& file,
                                   std::span<const SettableCommand> commands, std::string_view command) {
  return Reader(file, commands, command).read(parse_toml(text, printable(file)));
}

}  // namespace csgsim::shell
