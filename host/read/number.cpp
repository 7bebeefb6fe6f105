#include "host/read/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace csgsim::read {

namespace {

/// For a decimal literal outside the range of doubles, whether it is below the range rather than above it.
bool is_tiny(std::string_view literal) {
  const std::size_t exponent_at = std::min(literal.find_first_of("eE"), literal.size());
  const std::string_view mantissa = literal.substr(0, exponent_at);
  const std::size_t first_digit = mantissa.find_first_not_of("0.");
  if (first_digit == std::string_view::npos) return true;
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  long long exponent = 0;
  if (exponent_at < literal.size()) {
    std::string_view digits = literal.substr(exponent_at + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (result.ec != std::errc{}) return digits.starts_with('-');
  }
  // Number of digits between the first digit and the point; negative if the first digit follows the point. Its
  // magnitude is below 2^31, as is the size of a file.
  const long long magnitude = static_cast<long long>(point) - static_cast<long long>(first_digit);
  return exponent < -magnitude;
}

std::optional<double> parse_decimal(std::string_view literal) {
  double value = 0;
  const auto result = std::from_chars(literal.data(), literal.data() + literal.size(), value);
  if (result.ec == std::errc::result_out_of_range || std::isinf(value)) {
    if (is_tiny(literal)) return 0.0;
    return std::nullopt;
  }
  return value;
}

std::optional<double> parse_magnitude(std::string_view literal) {
  if (literal == "inf") return std::numeric_limits<double>::infinity();
  if (literal == "nan") return std::numeric_limits<double>::quiet_NaN();
  return parse_decimal(literal);
}

}  // namespace

std::optional<double> parse_number(std::string_view literal) {
  const bool negative = literal.starts_with('-');
  if (negative || literal.starts_with('+')) literal.remove_prefix(1);
  const std::optional<double> magnitude = parse_magnitude(literal);
  if (magnitude && negative) return -*magnitude;
  return magnitude;
}

}  // namespace csgsim::read
