// The most expensive primitives of a picture as a table cell.
// Used by the rows of compare.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/observe/primitive_costs.h"

namespace csgsim::studies {

/// A primitive and its cost.
struct CostlyPrimitive {
  std::string name;          ///< `cylinder@9:9`, escaped
  std::uint64_t clocks = 0;  ///< clocks of its instructions in all segments

  bool operator==(const CostlyPrimitive&) const = default;
};

/// Most expensive first.
using CostlyPrimitives = std::vector<CostlyPrimitive>;

CostlyPrimitives costly_primitives(const observe::ClockShares& shares);

/// A cell of a table, such as `cylinder@9:9=1234 cube@4:4=56`.
std::string to_cell(const CostlyPrimitives& primitives);

/// Throws InputError if the cell has another form.
void from_cell(const std::string& cell, CostlyPrimitives& primitives);

void set_json(nlohmann::ordered_json& row, const char* name, const CostlyPrimitives& primitives);

}  // namespace csgsim::studies
