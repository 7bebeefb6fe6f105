// Process files.

#include "hw/process/process.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "hw/kinds/load.h"
#include "hw/process/price.h"
#include "tests/fuzz/figures.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace machines = csgsim::machines;
namespace process = csgsim::process;

namespace {

/// A process file with the same parameters.
std::string description_of(const process::Process& one) {
  std::string text =
      fmt::format("name = {}\ndescription = {}\n", fuzz::toml_string(one.name), fuzz::toml_string(one.description));
  for (const machines::Figure& figure : one.figures)
    text += fmt::format("[{}]\nvalue = {}\n{}provenance = {}\nsource = {}\n", figure.key,
                        figure.key == "logic.family" ? fuzz::toml_string(figure.value) : figure.value,
                        figure.unit.empty() ? "" : fmt::format("unit = {}\n", fuzz::toml_string(figure.unit)),
                        fuzz::toml_string(figure.provenance), fuzz::toml_string(figure.source)) +
            fuzz::range_lines(figure);
  return text;
}

void check_prices(const process::Process& one) {
  static const machines::Machine machine = csgsim::kinds::load("pixel-planes-4");
  const machines::Resources resources{1U << 18U, std::uint64_t{72} << 18U};
  const auto clock = process::clock_of(machine, one);
  fuzz::require(clock && clock->hz > 0 && clock->path.ps > 0, "the clock frequency is positive");
  const auto mm2 = process::machine_mm2(machine, resources, one);
  fuzz::require(mm2 && std::isfinite(*mm2) && *mm2 > 0, "a machine has an area");
  const auto joules = process::frame_joules(machine, resources, {1000, 1}, one);
  fuzz::require(joules && std::isfinite(*joules) && *joules >= 0, "a frame has an energy");
}

void check(const process::Process& one) {
  fuzz::require(one.figures.size() == 20, "a process has every parameter");
  check_prices(one);
  try {
    const process::Process again = process::read_process(description_of(one), "again.toml");
    fuzz::require(again.name == one.name && again.description == one.description &&
                      again.gate_delay == one.gate_delay && again.wire_capacitance == one.wire_capacitance &&
                      again.family == one.family && fuzz::same_figures(again.figures, one.figures),
                  "a process described again is the same");
  } catch (const csgsim::InputError& error) {
    fuzz::broken(error.what());
  }
}

}  // namespace

/// Any bytes give a process with every parameter or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check(process::read_process(fuzz::text_of(data, size), "fuzz.toml"));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.toml");
  }
  return 0;
}
