#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::machines {

/// One figure of a machine description, with where it comes from.
struct Figure {
  std::string key;         ///< as in the file, for instance `array.width`
  std::string value;       ///< as text
  std::string unit;        ///< may be empty
  std::string provenance;  ///< `published` or `assumed`
  std::string source;      ///< the publication, or why it is assumed so
};

/// A logic-enhanced frame buffer, as its description in hw/machines/NAME.toml says.
struct Machine {
  std::string name;
  std::string description;
  isa::ArrayShape array;           ///< pixel processors and memory bits of each
  std::uint64_t clock_hz = 0;      ///< instruction bit steps a second
  std::uint32_t memory_reads = 1;  ///< reads of pixel memory a clock: 1 or 2
  bool has_global_or = true;       ///< the controller learns whether any pixel is enabled
  std::vector<Figure> figures;     ///< every figure of the file, in its order
};

/// Names of the machines that come with csgsim.
std::vector<std::string_view> built_in_names();

/// A built-in machine by name, or one described in a file (anything ending in .toml). Throws InputError: an unknown
/// name (with the nearest one), unknown key, wrong type, value out of range, each with file:line:column.
Machine load(const std::string& name_or_file);

}  // namespace csgsim::machines
