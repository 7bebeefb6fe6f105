#include "host/flat/dxf/tags.h"

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "hw/base/error.h"
#include "hw/base/text.h"

namespace csgsim::flat::dxf {

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view white = " \t\r\n\v\f";
  const std::size_t first = text.find_first_not_of(white);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(white) - first + 1);
}

template <typename Number>
std::optional<Number> parse(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

[[noreturn]] void fail(std::size_t line, std::string_view text, const std::string& what) {
  constexpr std::size_t shown = 40;
  throw InputError("line " + std::to_string(line) + ": \"" + printable(text.substr(0, shown)) + "\" is " + what);
}

}  // namespace

std::string_view Tags::take_line() {
  const std::size_t length = rest_.find('\n');
  const std::string_view line = rest_.substr(0, length);
  rest_.remove_prefix(length == std::string_view::npos ? rest_.size() : length + 1);
  ++line_;
  return trimmed(line);
}

std::optional<Tag> Tags::next() {
  if (rest_.find_first_not_of(" \t\r\n\x1a") == std::string_view::npos) return std::nullopt;
  const std::string_view text = take_line();
  const std::optional<int> code = parse<int>(text);
  if (!code) fail(line_, text, "not a group code of ASCII DXF; every other line must be one");
  const std::string_view value = take_line();
  return Tag{*code, value, line_};
}

double parse_real(const Tag& tag) {
  const std::optional<double> value = parse<double>(tag.value);
  if (!value || !std::isfinite(*value))
    fail(tag.line, tag.value, "not a number, but group " + std::to_string(tag.code) + " must be one");
  return *value;
}

int parse_integer(const Tag& tag) {
  const std::optional<int> value = parse<int>(tag.value);
  if (!value) fail(tag.line, tag.value, "not a whole number, but group " + std::to_string(tag.code) + " must be one");
  return *value;
}

}  // namespace csgsim::flat::dxf
