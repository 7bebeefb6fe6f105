// Layout of the pixel memory of a Program as a table cell.
// Used by the rows of sweep.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::studies {

/// Range of bits of a pixel's memory with one use. The bits of a stack are one range, and so are stored depths.
struct MemoryPart {
  std::string name;
  std::uint32_t base = 0;
  std::uint32_t width = 0;

  bool operator==(const MemoryPart&) const = default;
};

using MemoryMap = std::vector<MemoryPart>;

MemoryMap memory_map(const isa::Program& program);

/// A cell of a table, such as `Z2=0:20 Z1=20:20 stack=65:3`: names with base and width.
std::string to_cell(const MemoryMap& map);

/// Throws InputError if the cell has another form.
void from_cell(const std::string& cell, MemoryMap& map);

void set_json(nlohmann::ordered_json& row, const char* name, const MemoryMap& map);

}  // namespace csgsim::studies
