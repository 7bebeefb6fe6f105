#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sim/software/cost/operations.h"

namespace csgsim::studies {

/// Operations by kind as a cell of a table: `load=12 store_long=3`, the kinds that there were.
struct OperationsCell {
  software::Operations operations;
};

std::string to_cell(const OperationsCell& cell);

/// Throws InputError.
void from_cell(const std::string& text, OperationsCell& cell);

void set_json(nlohmann::ordered_json& row, const char* name, const OperationsCell& cell);

}  // namespace csgsim::studies
