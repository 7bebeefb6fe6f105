#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// As a cell of a table: `load=12 store_long=3`, the kinds that there were.
std::string to_cell(const Operations& operations);

/// Throws InputError.
void from_cell(const std::string& cell, Operations& operations);

void set_json(nlohmann::ordered_json& row, const char* name, const Operations& operations);

}  // namespace csgsim::software
