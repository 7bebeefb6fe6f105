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
  std::uint64_t gate_delay = 0;        ///< ps, for a gate with a typical fan-out
  std::uint64_t gate_fan_in = 0;       ///< maximum number of inputs of a gate
  std::uint64_t static_power = 0;      ///< pW per gate, independent of activity
  std::uint64_t family = 0;            ///< machines::LogicFamily
  std::uint64_t utilization = 0;       ///< percent of the area of logic that its transistors occupy, the rest is wires
  std::uint64_t supply = 0;            ///< mV
  std::uint64_t register_delay = 0;    ///< ps, setup time plus clock-to-output delay
  std::uint64_t register_energy = 0;   ///< aJ per clocked bit, without the wires of the clock
  std::uint64_t adder_energy = 0;      ///< aJ per bit
  std::uint64_t clock_lines = 0;       ///< clock wires that cross each pixel
  std::uint64_t memory_access = 0;     ///< ps, bit lines and sensing, after the decoder
  std::uint64_t memory_energy = 0;     ///< aJ per bit read, for a memory of `memory_bits` bits
  std::uint64_t memory_bits = 0;       ///< size of that memory
  std::uint64_t cell_transistors = 0;  ///< transistors of a memory cell with one read port and one write port
  std::uint64_t cell_area = 0;         ///< nm² of that cell
  std::uint64_t periphery = 0;         ///< area of decoders, drivers and sense amplifiers, percent of the cells
  std::uint64_t refresh_time = 0;      ///< ns in which each dynamic cell must be refreshed; 0: static cells
  std::uint64_t transistor_area = 0;   ///< nm² per logic transistor at full utilization
  std::uint64_t wire_delay = 0;        ///< ps per mm, with drivers
  std::uint64_t wire_capacitance = 0;  ///< fF per mm, with drivers
  std::vector<machines::Figure> figures;  ///< every parameter of the file, in the order of the file
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
