#include "sim/web/lacking/number.h"

#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace csgsim::web {

namespace {

bool is_digit(const char* at, const char* last) { return at != last && *at >= '0' && *at <= '9'; }

/// End of the digits that begin at `at`.
const char* digits_end(const char* at, const char* last) {
  while (is_digit(at, last)) ++at;
  return at;
}

/// End of an exponent, or its beginning if it is not one.
const char* exponent_end(const char* begin, const char* last) {
  if (begin == last || (*begin != 'e' && *begin != 'E')) return begin;
  const char* at = begin + 1;
  if (at != last && (*at == '+' || *at == '-')) ++at;
  return is_digit(at, last) ? digits_end(at, last) : begin;
}

/// End of a word for infinity or not-a-number, or its beginning.
const char* word_end(const char* begin, const char* last) {
  for (const std::string_view word : {"infinity", "inf", "nan"}) {
    std::size_t same = 0;
    while (same < word.size() && begin + same != last && (begin[same] | 0x20) == word[same]) ++same;
    if (same == word.size()) return begin + same;
  }
  return begin;
}

/// End of a number without leading blank or plus; null if there is none.
const char* number_end(const char* first, const char* last) {
  const char* const begin = first != last && *first == '-' ? first + 1 : first;
  const char* end = digits_end(begin, last);
  auto digits = end - begin;
  if (end != last && *end == '.') {
    const char* const fraction = end + 1;
    const char* const behind = digits_end(fraction, last);
    digits += behind - fraction;
    if (digits > 0) end = behind;
  }
  if (digits > 0) return exponent_end(end, last);
  end = word_end(begin, last);
  return end == begin ? nullptr : end;
}

/// Whether the mantissa has a digit other than 0.
bool has_value(std::string_view text) { return text.find_first_of("123456789") < text.find_first_of("eE"); }

template <class Number, class Parse>
std::from_chars_result read(const char* first, const char* last, Number& value, Parse parse) {
  const char* const end = number_end(first, last);
  if (end == nullptr) return {first, std::errc::invalid_argument};
  const std::string text(first, end);
  const Number number = parse(text.c_str());
  const bool is_word = text.find_first_of("0123456789") == std::string::npos;
  if (!is_word && (std::isinf(number) || (number == 0 && has_value(text))))
    return {end, std::errc::result_out_of_range};
  value = number;
  return {end, std::errc{}};
}

}  // namespace

std::from_chars_result read_number(const char* first, const char* last, double& value) {
  return read(first, last, value, [](const char* text) { return std::strtod(text, nullptr); });
}

std::from_chars_result read_number(const char* first, const char* last, float& value) {
  return read(first, last, value, [](const char* text) { return std::strtof(text, nullptr); });
}

}  // namespace csgsim::web
