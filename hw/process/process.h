// Parameters of a silicon process.
// Used by price.h, load.cpp, sim/studies and sim/app.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"

// Silicon processes: parameters of a process, from which a machine's clock, area and energy follow. A model
// (docs/design-space.md).
namespace csgsim::process {

/// A process, as described in hw/process/NAME.toml.
struct Process {
  std::string name;
  std::string description;
  std::uint64_t gate_delay = 0;              ///< ps, for a gate with a typical fan-out
  std::uint64_t gate_fan_in = 0;             ///< maximum number of inputs of a gate
  std::uint64_t register_delay = 0;          ///< ps, setup time plus clock-to-output delay
  std::uint64_t memory_access = 0;           ///< ps, bit lines and sensing, after the decoder
  std::uint64_t wire_delay = 0;              ///< ps per mm, with drivers
  std::uint64_t transistor_area = 0;         ///< nm² per logic transistor with its share of wires
  std::uint64_t memory_transistor_area = 0;  ///< nm² per transistor of a memory cell
  std::uint64_t adder_energy = 0;            ///< aJ per bit
  std::uint64_t register_energy = 0;         ///< aJ per clocked bit
  std::uint64_t memory_energy = 0;           ///< aJ per bit read, for a memory of `memory_bits` bits
  std::uint64_t memory_bits = 0;             ///< size of that memory
  std::uint64_t wire_energy = 0;             ///< aJ per bit and mm
  std::uint64_t static_power = 0;            ///< pW per gate, independent of activity
  std::vector<machines::Figure> figures;     ///< every parameter of the file, in the order of the file
};

/// Reads a description (TOML); `file` is its name in messages. Throws InputError with file:line:column. Each of
/// `changes`, KEY=VALUE, then replaces a parameter's value; throws machines::ChangeError for a wrong change.
Process read_process(std::string_view text, std::string_view file, std::span<const std::string> changes = {});

/// Names of the built-in processes.
std::vector<std::string_view> process_names();

/// Loads a built-in process by name, or a description file that ends in .toml. Changed parameters may follow, and an
/// edited file of a built-in process gets a name that lists the edits, as for machines (hw/kinds/load.h). Throws
/// InputError or machines::ChangeError.
Process load_process(const std::string& spec);

}  // namespace csgsim::process
