#pragma once

#include <string>
#include <vector>

#include "sim/software/work.h"
#include "sim/studies/compare/measure.h"

namespace csgsim::studies {

/// What software takes for the point's picture, on one processor: `machine` is PROCESSOR:METHOD. The tree is balanced.
/// Colours are not worked out. Clocks are 0 on this computer, whose time is measured. Throws InputError as the method
/// does.
void measure_software(const ComparisonJob& job, const model::Tree& tree, ComparisonRow& row);

/// PROCESSOR:METHOD or PROCESSOR:METHOD/COHERENCE, with commas between several. Throws InputError.
std::vector<SoftwareChoice> software_choices(const std::string& list);

}  // namespace csgsim::studies
