#include "hw/machines/quantity.h"

#include <string>
#include <utility>

#include "hw/kinds/load.h"
#include "hw/machines/change_error.h"
#include "tests/support/test.h"

using csgsim::InputError;
using csgsim::machines::parse_quantity;

TEST_CASE("a quantity has an SI prefix, an exponent or neither") {
  for (const char* const text : {"20000000", "20e6", "2E7", "20MHz", "20 MHz", "20.0MHz", "20000kHz", "20000KHz",
                                 "0.02GHz", "20000000Hz", ".02e3MHz", "2e+7"}) {
    CAPTURE(text);
    CHECK(parse_quantity(text, "Hz") == 20'000'000);
  }
}

TEST_CASE("a quantity is converted to the unit of its parameter exactly") {
  const std::pair<std::pair<const char*, const char*>, std::int64_t> quantities[] = {
      {{"1.5ns", "ps"}, 1500},
      {{"1.5us", "ps"}, 1'500'000},
      {{"1.5\u00b5s", "ps"}, 1'500'000},
      {{"0.1ns", "ps a mm"}, 100},
      {{"0.1ns a mm", "ps a mm"}, 100},
      {{"2.5pJ", "fJ"}, 2500},
      {{"2.5fJ", "aJ a bit"}, 2500},
      {{"1.5mW", "uW"}, 1500},
      {{"1.5um2", "nm2"}, 1'500'000},
      {{"2bytes", "bits"}, 16},
      {{"2 bytes", "bits"}, 16},
      {{"1kbit", "bits"}, 1000},
      {{"1Kibit", "bits"}, 1024},
      {{"1KiB", "bits"}, 8192},
      {{"72bits", "bits"}, 72},
      {{"3clocks", "clocks"}, 3},
      {{"1 clock", "clocks"}, 1},
      {{"2e3", "pixels"}, 2000},
      {{"0.0", "bits"}, 0},
      {{"100000000000000000e-17", "bits"}, 1}};
  for (const auto& each : quantities) {
    CAPTURE(each.first.first);
    CHECK(parse_quantity(each.first.first, each.first.second) == each.second);
  }
}

TEST_CASE("other units, fractions of a unit and other texts are rejected with what to write") {
  constexpr const char* hertz = "write a whole number of Hz, or a quantity such as 20MHz";
  for (const char* const text : {"20ms", "20M", "20mhz", "20MHx", "50ns", "fast", "", "MHz", "0.5", "20 M Hz", "-20MHz",
                                 "1e99", "99999999999999999999", "1e", "20e6e6", "20bits", "1.2.3MHz"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS(parse_quantity(text, "Hz"), hertz, InputError);
  }
  CHECK_THROWS_WITH_AS(parse_quantity("1.5bits", "bits"), "write a whole number of bits, or a quantity such as 2bytes",
                       InputError);
  CHECK_THROWS_WITH_AS(parse_quantity("3us", "clocks"), "write a whole number of clocks", InputError);
  CHECK_THROWS_WITH_AS(parse_quantity("2x", "a clock"), "write a whole number", InputError);
  CHECK_THROWS_WITH_AS(parse_quantity("2x", ""), "write a whole number", InputError);
}

TEST_CASE("a quantity sets a machine's parameter, and its name has the plain number") {
  const csgsim::machines::Machine machine = csgsim::kinds::load("pixel-planes-4+clock.frequency=20MHz");
  CHECK(machine.clock_hz == 20'000'000);
  CHECK(machine.name == "pixel-planes-4+clock.frequency=20000000");
  CHECK_THROWS_WITH_AS(csgsim::kinds::load("pixel-planes-4+clock.frequency=20ms"),
                       "pixel-planes-4+clock.frequency=20ms: clock.frequency is '20ms'; write a whole number of Hz, or "
                       "a quantity such as 20MHz",
                       csgsim::machines::ChangeError);
}
