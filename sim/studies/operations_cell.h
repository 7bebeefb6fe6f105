// Operation counts as a table cell.
// Used by the studies of software.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sim/software/cost/operations.h"

namespace csgsim::studies {

/// Nonzero operation counts by kind as a cell of a table: `load=12 store_long=3`.
struct OperationsCell {
  software::Operations operations;
};

std::string to_cell(const OperationsCell& cell);

/// Throws InputError if the text has another form or an unknown operation.
void from_cell(const std::string& text, OperationsCell& cell);

void set_json(nlohmann::ordered_json& row, const char* name, const OperationsCell& cell);

}  // namespace csgsim::studies
