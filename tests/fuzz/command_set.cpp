// Command sets of memories with latches.

#include "hw/bit_serial_memory/command_set.h"

#include <fmt/format.h>

#include <string>

#include "hw/bit_serial_memory/gate_mapper.h"
#include "tests/fuzz/figures.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace memory = csgsim::bit_serial_memory;

namespace {

std::string place_name(memory::Place place) {
  if (place >= memory::first_temporary) return fmt::format("T{}", place - memory::first_temporary + 1);
  return std::string(place == memory::target_place ? "target" : std::string(1, static_cast<char>('x' + place)));
}

/// A file with the same set.
std::string text_of(const memory::CommandSet& set) {
  std::string text = fmt::format("name = {}\ndescription = {}\ntemporaries = {}\n", fuzz::toml_string(set.name),
                                 fuzz::toml_string(set.description), set.temporaries);
  for (const memory::GateCommand& command : set.commands) {
    std::string table;
    for (unsigned i = 0; i < 1U << command.inputs; ++i) table += (command.table >> i & 1U) != 0 ? '1' : '0';
    text += fmt::format("[command.{}]\ntable = \"{}\"\nclocks = {}\nenergy = {}\nprovenance = \"{}\"\nsource = {}\n",
                        command.name, table, command.clocks, command.energy_fj,
                        command.is_published ? "published" : "assumed", fuzz::toml_string(command.source));
  }
  text += "[sequence]\n";
  for (std::size_t gate = 0; gate < set.given.size(); ++gate) {
    if (!set.given[gate]) continue;
    text += fmt::format("{} = [", memory::gate_names[gate]);
    for (const memory::GateStep& step : *set.given[gate]) {
      const memory::GateCommand& command = set.commands[step.command];
      text += fmt::format("\"{} = {}", place_name(step.target), command.name);
      for (std::size_t i = 0; i < command.inputs; ++i) text += " " + place_name(step.inputs[i]);
      text += "\",";
    }
    text += "]\n";
  }
  return text;
}

void check(const memory::CommandSet& set) {
  fuzz::require(!set.commands.empty(), "a set has a command");
  for (std::size_t gate = 0; gate < set.given.size(); ++gate) {
    if (set.given[gate])
      fuzz::require(memory::computes(*set.given[gate], static_cast<memory::Gate>(gate), memory::no_aliases, set),
                    "a given sequence computes its gate");
  }
  try {
    const std::string text = text_of(set);
    fuzz::require(text_of(memory::read_command_set(text, "again.toml")) == text, "a set described again is the same");
  } catch (const csgsim::InputError& error) {
    fuzz::broken(error.what());
  }
}

}  // namespace

/// Any bytes give a command set or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check(memory::read_command_set(fuzz::text_of(data, size), "fuzz.toml"));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.toml");
  }
  return 0;
}
