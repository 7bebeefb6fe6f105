#include "sim/web/lacking/number.h"

#include <charconv>
#include <system_error>

#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Compares the parsed number with the standard library's.
template <class Number>
void check_same(const std::string& text) {
  CAPTURE(text);
  Number value = 7;
  Number other = 7;
  const char* const end = text.data() + text.size();
  const std::from_chars_result read = web::read_number(text.data(), end, value);
  const std::from_chars_result expected = std::from_chars(text.data(), end, other);
  CHECK(read.ec == expected.ec);
  CHECK(read.ptr - text.data() == expected.ptr - text.data());
  CHECK((std::isnan(other) ? std::isnan(value) : value == other));
}

void check_same_numbers(const std::string& text) {
  check_same<double>(text);
  check_same<float>(text);
}

}  // namespace

TEST_CASE("web::read_number() accepts and rejects texts like std::from_chars()") {
  for (const char* const text : {"",
                                 "-",
                                 "+1",
                                 " 1",
                                 ".",
                                 "-.",
                                 ".5",
                                 "5.",
                                 "5.e2",
                                 "-0",
                                 "0x10",
                                 "1e",
                                 "1e+",
                                 "1e5x",
                                 "1E-3",
                                 "1.2.3",
                                 "inf",
                                 "-INFINITY",
                                 "infinite",
                                 "nan",
                                 "NaN",
                                 "in",
                                 "e5",
                                 "1e400",
                                 "-1e400",
                                 "1e-400",
                                 "0e-400",
                                 "0.0e999",
                                 "1e39",
                                 "1e-50",
                                 "123456789012345678901234567890",
                                 "00012.50"})
    check_same_numbers(text);
}

TEST_CASE("web::read_number() reads random number characters like std::from_chars()") {
  std::mt19937 generator(5);
  const std::string letters = "0123456789.eE+-";
  for (int round = 0; round < 20'000; ++round) {
    std::string text;
    for (auto length = generator() % 10; length > 0; --length) text += letters[generator() % letters.size()];
    check_same_numbers(text);
  }
}

TEST_CASE("web::read_number() reads random doubles printed by std::to_chars() exactly") {
  std::mt19937_64 generator(9);
  for (int round = 0; round < 20'000; ++round) {
    const auto number = std::bit_cast<double>(generator());
    if (!std::isfinite(number)) continue;
    std::string text(32, ' ');
    text.resize(
        static_cast<std::size_t>(std::to_chars(text.data(), text.data() + text.size(), number).ptr - text.data()));
    double value = 0;
    CHECK(web::read_number(text.data(), text.data() + text.size(), value).ec == std::errc{});
    CHECK(value == number);
  }
}
