#include "hw/machines/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <system_error>

#include "hw/base/error.h"

namespace csgsim::machines {

namespace {

constexpr std::int64_t max_value = 1'000'000'000'000'000'000;

/// A unit of parameters as a multiple of a unit without prefix.
struct KnownUnit {
  std::string_view unit;       ///< as in machine files
  std::string_view plain;      ///< without prefix
  int exponent = 0;            ///< of ten
  int prefix_power = 1;        ///< 2 for areas
  std::string_view example;    ///< for messages
  std::string_view rest = {};  ///< follows the plain unit
};

constexpr auto known_units = std::to_array<KnownUnit>({
    {"Hz", "Hz", 0, 1, "20MHz"},
    {"ps", "s", -12, 1, "1.5ns"},
    {"ps a mm", "s", -12, 1, "0.1ns", " a mm"},
    {"fJ", "J", -15, 1, "2.5pJ"},
    {"aJ a bit", "J", -18, 1, "2.5fJ", " a bit"},
    {"aJ a bit and mm", "J", -18, 1, "2.5fJ", " a bit and mm"},
    {"uW", "W", -6, 1, "1.5mW"},
    {"pW", "W", -12, 1, "1.5nW"},
    {"nm2", "m2", -18, 2, "1.5um2"},
});

/// A prefix and its power of ten.
struct Prefix {
  std::string_view name;
  int exponent = 0;
};

constexpr auto prefixes = std::to_array<Prefix>({{"a", -18},
                                                 {"f", -15},
                                                 {"p", -12},
                                                 {"n", -9},
                                                 {"u", -6},
                                                 {"\u00b5", -6},
                                                 {"m", -3},
                                                 {"", 0},
                                                 {"k", 3},
                                                 {"K", 3},
                                                 {"M", 6},
                                                 {"G", 9},
                                                 {"T", 12}});

/// A unit relative to that of a parameter: factor * 10^exponent.
struct Scale {
  std::int64_t factor = 1;
  int exponent = 0;
};

/// A decimal number: digits * 10^exponent.
struct Decimal {
  std::int64_t digits = 0;
  int exponent = 0;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Removes and returns an exponent such as `e6`; 0 if the text does not begin with one.
int take_exponent(std::string_view& text) {
  if (!text.starts_with('e') && !text.starts_with('E')) return 0;
  std::string_view rest = text.substr(1);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  int exponent = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), exponent);
  if (error != std::errc{} || std::abs(exponent) > 99) return 0;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return exponent;
}

/// Removes and returns a number with at most 18 significant digits; nothing if the text does not begin with one.
std::optional<Decimal> take_number(std::string_view& text) {
  Decimal number;
  bool has_digits = false;
  bool is_fraction = false;
  while (!text.empty() && (is_digit(text.front()) || (text.front() == '.' && !is_fraction))) {
    if (text.front() == '.') {
      is_fraction = true;
    } else {
      has_digits = true;
      if (number.digits >= max_value / 10) return std::nullopt;
      number.digits = number.digits * 10 + (text.front() - '0');
      if (is_fraction) --number.exponent;
    }
    text.remove_prefix(1);
  }
  if (!has_digits) return std::nullopt;
  number.exponent += take_exponent(text);
  return number;
}

/// Scale of a word such as `MHz`; nothing if it is no form of the unit.
std::optional<Scale> scale_of(std::string_view word, const KnownUnit& unit) {
  if (!unit.rest.empty() && word.ends_with(unit.rest)) word.remove_suffix(unit.rest.size());
  if (!word.ends_with(unit.plain)) return std::nullopt;
  word.remove_suffix(unit.plain.size());
  const auto* const found = std::ranges::find(prefixes, word, &Prefix::name);
  if (found == prefixes.end()) return std::nullopt;
  return Scale{1, found->exponent * unit.prefix_power - unit.exponent};
}

/// Scale of bits or bytes, with the prefixes k, M and G, or Ki, Mi and Gi.
std::optional<Scale> scale_of_bits(std::string_view word) {
  constexpr int bits_a_byte = 8;
  Scale scale;
  const auto remove = [&](std::string_view end) {
    if (!word.ends_with(end)) return false;
    word.remove_suffix(end.size());
    return true;
  };
  if (remove("bytes") || remove("byte") || remove("B")) {
    scale.factor = bits_a_byte;
  } else if (!remove("bits") && !remove("bit")) {
    return std::nullopt;
  }
  const bool is_binary = remove("i");
  const auto* const found = std::ranges::find(prefixes, word, &Prefix::name);
  if (found == prefixes.end() || found->exponent < 0 || (is_binary && found->exponent == 0)) return std::nullopt;
  if (!is_binary) {
    scale.exponent = found->exponent;
    return scale;
  }
  for (int i = 0; i < found->exponent; i += 3) scale.factor *= 1024;
  return scale;
}

/// Whether the word is a counted unit in singular or plural: `clock` or `clocks`.
bool is_counted_unit(std::string_view word, std::string_view unit) {
  return word == unit || (unit.ends_with('s') && word == unit.substr(0, unit.size() - 1));
}

const KnownUnit* known_unit(std::string_view unit) {
  const auto* const found = std::ranges::find(known_units, unit, &KnownUnit::unit);
  return found == known_units.end() ? nullptr : found;
}

std::optional<Scale> scale_in(std::string_view word, std::string_view unit) {
  if (word.empty() || is_counted_unit(word, unit)) return Scale{};
  if (unit == "bits") return scale_of_bits(word);
  const KnownUnit* const known = known_unit(unit);
  return known == nullptr ? std::nullopt : scale_of(word, *known);
}

[[noreturn]] void fail_form(std::string_view unit) {
  if (unit.empty() || unit.starts_with("a ")) throw InputError("write a whole number");
  if (const KnownUnit* const known = known_unit(unit))
    throw InputError(fmt::format("write a whole number of {}, or a quantity such as {}", unit, known->example));
  if (unit == "bits") throw InputError("write a whole number of bits, or a quantity such as 2bytes");
  throw InputError(fmt::format("write a whole number of {}", unit));
}

/// The whole number, or nothing if it is a fraction or too large.
std::optional<std::int64_t> whole(Decimal number, const Scale& scale) {
  if (number.digits == 0) return 0;
  if (number.digits > max_value / scale.factor) return std::nullopt;
  std::int64_t value = number.digits * scale.factor;
  int exponent = number.exponent + scale.exponent;
  for (; exponent > 0; --exponent) {
    if (value > max_value / 10) return std::nullopt;
    value *= 10;
  }
  for (; exponent < 0; ++exponent) {
    if (value % 10 != 0) return std::nullopt;
    value /= 10;
  }
  return value;
}

}  // namespace

std::int64_t parse_quantity(std::string_view text, std::string_view unit) {
  const std::optional<Decimal> number = take_number(text);
  if (!number) fail_form(unit);
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const std::optional<Scale> scale = scale_in(text, unit);
  if (!scale) fail_form(unit);
  const std::optional<std::int64_t> value = whole(*number, *scale);
  if (!value) fail_form(unit);
  return *value;
}

}  // namespace csgsim::machines
