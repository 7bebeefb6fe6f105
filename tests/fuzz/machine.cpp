// Machine files.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>

#include "hw/kinds/rows.h"
#include "hw/machines/description.h"
#include "tests/fuzz/figures.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace kinds = csgsim::kinds;
namespace machines = csgsim::machines;

namespace {

const machines::FigureSchema& schema_of(const machines::Machine& machine, const machines::Figure& figure) {
  const auto found = std::ranges::find(machine.kind->schema, figure.key, &machines::FigureSchema::key);
  fuzz::require(found != machine.kind->schema.end(), "every parameter belongs to its kind");
  return *found;
}

/// A machine file with the same parameters.
std::string description_of(const machines::Machine& machine) {
  std::string text = fmt::format("name = {}\ndescription = {}\nkind = \"{}\"\n", fuzz::toml_string(machine.name),
                                 fuzz::toml_string(machine.description), machine.kind->name);
  for (const machines::Figure& figure : machine.figures) {
    const bool is_name = !schema_of(machine, figure).names.empty() || figure.value == machines::ideal_value ||
                         figure.value == machines::priced_value;
    text += fmt::format("[{}]\nvalue = {}\n", figure.key, is_name ? fuzz::toml_string(figure.value) : figure.value);
    if (!figure.unit.empty()) text += fmt::format("unit = {}\n", fuzz::toml_string(figure.unit));
    text += fmt::format("provenance = {}\nsource = {}\n", fuzz::toml_string(figure.provenance),
                        fuzz::toml_string(figure.source)) +
            fuzz::range_lines(figure);
  }
  return text;
}

bool is_within(const machines::Figure& figure, const machines::FigureSchema& schema) {
  if (schema.ideal && figure.value == machines::ideal_value) return true;
  if (schema.priced && figure.value == machines::priced_value) return true;
  if (!schema.names.empty()) return std::ranges::find(schema.names, figure.value) != schema.names.end();
  std::int64_t value = 0;
  const char* const end = figure.value.data() + figure.value.size();
  return std::from_chars(figure.value.data(), end, value).ptr == end && value >= schema.least && value <= schema.most;
}

bool same_machine(const machines::Machine& one, const machines::Machine& other) {
  return one.name == other.name && one.description == other.description && one.kind == other.kind &&
         one.array == other.array && one.picture == other.picture && one.clock_hz == other.clock_hz &&
         one.memory_reads == other.memory_reads && one.alu_bits == other.alu_bits &&
         machines::is_same_hardware(one, other) && fuzz::same_figures(one.figures, other.figures);
}

void check(const machines::Machine& machine) {
  for (const machines::FigureSchema& schema : machine.kind->schema) {
    fuzz::require(std::ranges::count(machine.figures, schema.key, &machines::Figure::key) == 1,
                  "a machine has every parameter of its kind once");
  }
  for (const machines::Figure& figure : machine.figures)
    fuzz::require(is_within(figure, schema_of(machine, figure)), "every parameter is within its range");
  try {
    fuzz::require(
        same_machine(machines::read_description(description_of(machine), "again.toml", kinds::all()), machine),
        "a machine described again is the same");
  } catch (const csgsim::InputError& error) {
    fuzz::broken(error.what());
  }
}

}  // namespace

/// Any bytes give a machine that satisfies the schema or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check(machines::read_description(fuzz::text_of(data, size), "fuzz.toml", kinds::all()));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.toml");
  }
  return 0;
}
