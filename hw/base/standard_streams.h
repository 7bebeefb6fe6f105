// Names and redirection of the standard streams.
// Used by hw/isa and sim.
#pragma once

#include <filesystem>
#include <string_view>

#include "hw/base/descriptor.h"

namespace csgsim {

/// The name that stands for standard input as an input and for standard output as an output. A file of that name is
/// written `./-`.
inline constexpr std::string_view standard_stream = "-";

/// Whether the path is `-` or one of the system's names for standard output.
bool is_standard_output(const std::filesystem::path& path);

/// Whether output written to the path appears on a terminal.
bool is_terminal(const std::filesystem::path& path);

/// Reserves standard output for the data of an output file; each call returns a new descriptor. From then on printed
/// text goes to standard error, so that it does not mix with the data.
Descriptor reserve_standard_output();

/// Discards all printed text from now on; messages on standard error are not affected.
void silence_prints();

/// Whether neither reserve_standard_output() nor silence_prints() has been called.
bool prints_to_standard_output();

/// Whether silence_prints() has been called.
bool is_silent();

}  // namespace csgsim
