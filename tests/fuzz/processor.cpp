// Processor files.

#include "hw/processors/processor.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "tests/fuzz/figures.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace machines = csgsim::machines;
namespace processors = csgsim::processors;

namespace {

/// A processor file with the same parameters.
std::string description_of(const processors::Processor& processor) {
  std::string text = fmt::format("name = {}\ndescription = {}\n", fuzz::toml_string(processor.name),
                                 fuzz::toml_string(processor.description));
  for (const machines::Figure& figure : processor.figures)
    text += fmt::format("[{}]\nvalue = {}\nunit = {}\nprovenance = {}\nsource = {}\n", figure.key, figure.value,
                        fuzz::toml_string(figure.unit), fuzz::toml_string(figure.provenance),
                        fuzz::toml_string(figure.source)) +
            fuzz::range_lines(figure);
  return text;
}

bool same_processor(const processors::Processor& one, const processors::Processor& other) {
  return one.name == other.name && one.description == other.description && one.clock_hz == other.clock_hz &&
         one.prices == other.prices && one.compiler_factors == other.compiler_factors &&
         one.memory_price == other.memory_price && fuzz::same_figures(one.figures, other.figures);
}

void check(const processors::Processor& processor) {
  for (std::size_t kind = 0; kind < processors::operation_kinds; ++kind) {
    const std::string key = fmt::format("price.{}", processors::operation_rows[kind].name);
    const auto found = std::ranges::find(processor.figures, key, &machines::Figure::key);
    fuzz::require(found != processor.figures.end(), "every operation has its price");
    fuzz::require(found->value == fmt::format("{}", processor.prices[kind]), "an operation has the price of the file");
  }
  fuzz::require(processor.clock_hz > 0 && std::ranges::min(processor.compiler_factors) > 0,
                "the clock frequency is positive, and work takes clocks");
  try {
    fuzz::require(same_processor(processors::read_processor(description_of(processor), "again.toml"), processor),
                  "a processor is read as described");
  } catch (const csgsim::InputError& error) {
    fuzz::broken(error.what());
  }
}

}  // namespace

/// Any bytes give a processor with every parameter or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check(processors::read_processor(fuzz::text_of(data, size), "fuzz.toml"));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.toml");
  }
  return 0;
}
