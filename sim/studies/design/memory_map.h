#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::studies {

/// Bits of a pixel's memory that hold one thing. The bits of a stack are one such part, and so are stored depths.
struct MemoryPart {
  std::string name;
  std::uint32_t base = 0;
  std::uint32_t width = 0;

  bool operator==(const MemoryPart&) const = default;
};

using MemoryMap = std::vector<MemoryPart>;

MemoryMap memory_map(const isa::Program& program);

/// As a cell of a table: `Z2=0:20 Z1=20:20 stack=65:3`, each name with base and width.
std::string to_cell(const MemoryMap& map);

/// Throws InputError.
void from_cell(const std::string& cell, MemoryMap& map);

void set_json(nlohmann::ordered_json& row, const char* name, const MemoryMap& map);

}  // namespace csgsim::studies
