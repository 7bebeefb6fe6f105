#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"

/// In what silicon a machine is made: figures of a process of its time, and what they make of a machine's clock, area
/// and energy. A model (docs/design-space.md).
namespace csgsim::process {

/// A process, as its description in hw/process/NAME.toml says.
struct Process {
  std::string name;
  std::string description;
  std::uint64_t gate_delay = 0;              ///< ps, of a gate with the load of some others
  std::uint64_t gate_fan_in = 0;             ///< inputs that a gate has at most
  std::uint64_t register_delay = 0;          ///< ps: setting it up, and until its output is there
  std::uint64_t memory_access = 0;           ///< ps: bit lines and sensing, behind the decoder
  std::uint64_t wire_delay = 0;              ///< ps a mm, with what drives it
  std::uint64_t transistor_area = 0;         ///< nm², one of logic with its share of wires
  std::uint64_t memory_transistor_area = 0;  ///< nm², one of a memory cell
  std::uint64_t adder_energy = 0;            ///< aJ a bit
  std::uint64_t register_energy = 0;         ///< aJ a bit that is clocked
  std::uint64_t memory_energy = 0;           ///< aJ a bit that is read, of a memory of `memory_bits`
  std::uint64_t memory_bits = 0;             ///< of that memory
  std::uint64_t wire_energy = 0;             ///< aJ a bit and mm
  std::uint64_t static_power = 0;            ///< pW that a gate draws whatever it does
  std::vector<machines::Figure> figures;     ///< every figure of the file, in its order
};

/// Reads a description (TOML); `file` is its name in messages. Throws InputError, with file:line:column. Then each of
/// `changes`, KEY=VALUE, takes the place of a figure's value; throws machines::ChangeError.
Process read_process(std::string_view text, std::string_view file, std::span<const std::string> changes = {});

/// Names of the processes that come with csgsim.
std::vector<std::string_view> process_names();

/// A process by name, or one described in a file, which ends in .toml; figures may be changed behind it, and an edited
/// file of one that comes with csgsim tells what is edited, as machines do (hw/kinds/load.h). Throws InputError, or
/// machines::ChangeError.
Process load_process(const std::string& said);

}  // namespace csgsim::process
