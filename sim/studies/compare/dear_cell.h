#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/observe/dearest.h"

namespace csgsim::studies {

/// A primitive that is among the dearest of a picture.
struct DearPrimitive {
  std::string name;          ///< `cylinder@9:9`, escaped
  std::uint64_t clocks = 0;  ///< of its instructions, in all segments

  bool operator==(const DearPrimitive&) const = default;
};

/// The dearest first.
using DearPrimitives = std::vector<DearPrimitive>;

DearPrimitives dear_primitives(const observe::ClockShares& shares);

/// As a cell of a table: `cylinder@9:9=1234 cube@4:4=56`.
std::string to_cell(const DearPrimitives& dear);

/// Throws InputError.
void from_cell(const std::string& cell, DearPrimitives& dear);

void set_json(nlohmann::ordered_json& row, const char* name, const DearPrimitives& dear);

}  // namespace csgsim::studies
