#include "host/flat/svg/numbers.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace csgsim::flat::svg {

namespace {

constexpr std::string_view white = " \t\n\r\f";

bool is_letter(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z');
}

void skip_white(std::string_view& text) {
  const std::size_t first = text.find_first_not_of(white);
  text.remove_prefix(first == std::string_view::npos ? text.size() : first);
}

}  // namespace

void Numbers::skip_separators() {
  skip_white(rest_);
  if (take(',')) skip_white(rest_);
}

std::optional<double> Numbers::number() {
  std::string_view digits = rest_;
  const bool negative = digits.starts_with('-');
  if (negative || digits.starts_with('+')) digits.remove_prefix(1);
  // from_chars would also accept words such as "inf", and a second sign.
  if (digits.empty() || (digits[0] != '.' && (digits[0] < '0' || digits[0] > '9'))) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  rest_ = digits.substr(static_cast<std::size_t>(end - digits.data()));
  return negative ? -value : value;
}

std::optional<bool> Numbers::flag() {
  if (take('0')) return false;
  if (take('1')) return true;
  return std::nullopt;
}

std::optional<char> Numbers::letter() {
  if (rest_.empty() || !is_letter(rest_[0])) return std::nullopt;
  const char found = rest_[0];
  rest_.remove_prefix(1);
  return found;
}

std::string_view Numbers::word() {
  std::size_t length = 0;
  while (length < rest_.size() && is_letter(rest_[length])) ++length;
  const std::string_view found = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return found;
}

bool Numbers::take(char character) {
  if (!rest_.starts_with(character)) return false;
  rest_.remove_prefix(1);
  return true;
}

std::optional<double> parse_single_number(std::string_view text) {
  Numbers numbers(text);
  const std::optional<double> value = numbers.number();
  return numbers.at_end() ? value : std::nullopt;
}

}  // namespace csgsim::flat::svg
