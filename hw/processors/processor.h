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

/// Programs whose compiler's factor differs, as it was measured of each (docs/host.md).
enum class Compiled : std::uint8_t {
  general,  ///< all programs without a measurement of their own
  standard,
  early_out,
  positional,
  status,
  bit_parallel,
};

inline constexpr std::size_t compiled_kinds = static_cast<std::size_t>(Compiled::bit_parallel) + 1;

/// A processor of its time, as its description in hw/processors/NAME.toml says.
struct Processor {
  std::string name;
  std::string description;
  std::uint64_t clock_hz = 0;                           ///< clocks a second
  std::array<std::uint32_t, operation_kinds> prices{};  ///< clocks of one operation of each kind
  /// Thousandths, by Compiled: what a program takes of the clocks of one that is written by hand.
  std::array<std::uint32_t, compiled_kinds> compiler_factors{};
  std::uint32_t memory_price = 0;         ///< dollars a Mbyte, of its year
  std::vector<machines::Figure> figures;  ///< every figure of the file, in its order
};

/// Reads a description (TOML); `file` is its name in messages. Throws InputError, with file:line:column. Then each of
/// `changes`, KEY=VALUE, takes the place of a figure's value, as in machines::read_description; throws
/// machines::ChangeError.
Processor read_processor(std::string_view text, std::string_view file, std::span<const std::string> changes = {});

/// What a figure is, by its key, for people. Throws std::out_of_range for a key that no processor has.
std::string_view meaning_of_figure(std::string_view key);

/// The word for the computer that measures, whose time is that of a clock on the wall.
inline constexpr const char* this_computer = "this-computer";

/// Names of the processors that come with csgsim.
std::vector<std::string_view> processor_names();

/// A processor by name, or one described in a file, which ends in .toml; figures may be changed behind it, and an
/// edited file of one that comes with csgsim tells what is edited, as machines do (hw/kinds/load.h). Throws InputError,
/// or machines::ChangeError.
Processor load_processor(const std::string& said);

/// Clocks that the operations of a program take, the compiler's factor included.
double clocks(const Operations& operations, const Processor& processor, Compiled program = Compiled::general);

/// The same in seconds.
double seconds(const Operations& operations, const Processor& processor, Compiled program = Compiled::general);

}  // namespace csgsim::processors
