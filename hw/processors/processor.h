// Processors with clocks per operation.
// Used by hw/host, hw/multi_processor, sim/app, sim/shell, sim/software and sim/studies.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/processors/operations.h"

namespace csgsim::processors {

/// Classes of programs with separately measured compiler factors (docs/host.md).
enum class Compiled : std::uint8_t {
  general,       ///< programs without their own measurement
  standard,      ///< standard traversal of the tree
  early_out,     ///< traversal with early out
  positional,    ///< positional coding
  status,        ///< status tree
  bit_parallel,  ///< bit-parallel methods
};

inline constexpr std::size_t compiled_kinds = static_cast<std::size_t>(Compiled::bit_parallel) + 1;

/// A processor, as described in hw/processors/NAME.toml.
struct Processor {
  std::string name;
  std::string description;
  std::uint64_t clock_hz = 0;                           ///< clocks per second
  std::array<std::uint32_t, operation_kinds> prices{};  ///< clocks per operation of each kind
  /// Clocks of a compiled program per thousand clocks of a hand-written one, by Compiled.
  std::array<std::uint32_t, compiled_kinds> compiler_factors{};
  std::uint32_t memory_price = 0;         ///< dollars per Mbyte in the year in which the processor appeared
  std::vector<machines::Figure> figures;  ///< every parameter of the file, in the order of the file
};

/// Reads a description (TOML); `file` is its name in messages. Throws InputError with file:line:column. Each of
/// `changes`, KEY=VALUE, then replaces a parameter's value, as in machines::read_description; throws
/// machines::ChangeError.
Processor read_processor(std::string_view text, std::string_view file, std::span<const std::string> changes = {});

/// Description of a parameter, by its key. Throws std::out_of_range for an unknown key.
std::string_view meaning_of_figure(std::string_view key);

/// Name of the computer that runs the measurement, which is timed by the wall clock.
inline constexpr const char* this_computer = "this-computer";

/// Names of the built-in processors.
std::vector<std::string_view> processor_names();

/// Loads a built-in processor by name, or a description file that ends in .toml. Changed parameters may follow, and an
/// edited file of a built-in processor gets a name that lists the edits, as for machines (hw/kinds/load.h). Throws
/// InputError or machines::ChangeError.
Processor load_processor(const std::string& spec);

/// The built-in processor with that name, which is read once. Throws std::out_of_range for an unknown name.
const Processor& built_in_processor(std::string_view name);

/// Clocks of a hand-written program's operations.
std::uint64_t hand_written_clocks(const Operations& operations, const Processor& processor);

/// Clocks of a program's operations, including the compiler factor.
double clocks(const Operations& operations, const Processor& processor, Compiled program_class = Compiled::general);

/// Seconds of a program's operations, including the compiler factor.
double seconds(const Operations& operations, const Processor& processor, Compiled program_class = Compiled::general);

}  // namespace csgsim::processors
