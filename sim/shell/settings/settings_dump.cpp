#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/locale/utf.hpp>
#include <string_view>

#include "hw/base/text.h"
#include "sim/shell/settings/settings_file.h"

namespace csgsim::shell {

namespace {

namespace utf = boost::locale::utf;

/// A TOML string of the bytes. Bytes that are not UTF-8, which TOML cannot hold, are written as escapes.
std::string toml_string(std::string_view bytes) {
  std::string text = "\"";
  for (auto at = bytes.begin(); at != bytes.end();) {
    const auto begin = at;
    const utf::code_point point = utf::utf_traits<char>::decode(at, bytes.end());
    if (!utf::is_valid_codepoint(point)) at = begin + 1;
    const std::string character(begin, at);
    const std::string shown = printable(character);
    if (character == "\"" || character == "\\") {
      text += '\\' + character;
    } else if (shown == character) {
      text += character;
    } else if (utf::is_valid_codepoint(point)) {
      text += fmt::format("\\U{:08x}", point);
    } else {
      text += '\\' + shown;
    }
  }
  return text + '"';
}

/// Placeholder value for an option without a value.
std::string_view example(Takes takes) {
  switch (takes) {
    case Takes::flag: return "false";
    case Takes::whole_number: return "0";
    case Takes::number: return "0.0";
    case Takes::text: return "\"\"";
    case Takes::texts: return "[]";
  }
  return "";
}

std::string value_text(const OptionValue& one) {
  switch (one.takes) {
    case Takes::flag:
    case Takes::whole_number:
    case Takes::number: return one.values.front();
    case Takes::text: return toml_string(one.values.front());
    case Takes::texts: break;
  }
  std::vector<std::string> all;
  for (const std::string& value : one.values) all.push_back(toml_string(value));
  return fmt::format("[{}]", fmt::join(all, ", "));
}

}  // namespace

std::string settings_text(const std::string& command, std::span<const OptionValue> options) {
  std::string text = fmt::format("# All options of csgsim {0}, for --config.\n\n[{0}]\n", command);
  for (const OptionValue& one : options) {
    text += fmt::format("\n# {}\n", one.meaning);
    text += one.values.empty() ? fmt::format("# {} = {}\n", one.name, example(one.takes))
                               : fmt::format("{} = {}\n", one.name, value_text(one));
  }
  return text;
}

}  // namespace csgsim::shell
