#include "hw/base/toml_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/base/error.h"

namespace csgsim {

namespace {

/// toml++ destroys nested tables recursively, and each part of a dotted key is a table, so this limit bounds the stack.
constexpr std::ptrdiff_t max_dots = 50;

void check_dots(std::string_view text, std::string_view file) {
  std::size_t line = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view content = text.substr(begin, end - begin);
    if (std::count(content.begin(), content.end(), '.') > max_dots)
      throw InputError(
          fmt::format("{}:{}:1: more than {} dots in a line; use keys with fewer parts, and split a long text over "
                      "several lines in triple quotes",
                      file, line, max_dots));
    begin = end + 1;
  }
}

}  // namespace

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::none: return "nothing";
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "an array";
    case toml::node_type::string: return "a string";
    case toml::node_type::integer: return "an integer";
    case toml::node_type::floating_point: return "a number with a point";
    case toml::node_type::boolean: return "a boolean";
    case toml::node_type::date: return "a date";
    case toml::node_type::time: return "a time";
    case toml::node_type::date_time: return "a date and time";
  }
  return "unknown";
}

std::string position_text(const toml::source_position& position, std::string_view file) {
  return fmt::format("{}:{}:{}", file, std::max(position.line, toml::source_index{1}),
                     std::max(position.column, toml::source_index{1}));
}

toml::table parse_toml(std::string_view text, std::string_view file) {
  check_dots(text, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    // A description names the construct first: `Error while parsing key-value pair: expected value`.
    const std::string_view what = error.description();
    const std::size_t colon = what.starts_with("Error while parsing ") ? what.find(": ") : what.npos;
    throw InputError(fmt::format("{}: this is not valid TOML: {}", position_text(error.source().begin, file),
                                 colon == what.npos ? what : what.substr(colon + 2)));
  }
}

}  // namespace csgsim
