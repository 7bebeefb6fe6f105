// Measurement of pictures drawn by software.
// Used by csgsim compare --with.
#pragma once

#include <string>
#include <vector>

#include "sim/software/work.h"
#include "sim/studies/compare/measure.h"

namespace csgsim::studies {

/// Measures software that draws the point's picture on one processor, with a balanced tree and without colours;
/// `machine` is PROCESSOR:METHOD. Clocks are 0 on this computer, where time is measured. Throws InputError if the
/// method cannot draw the picture.
void measure_software(const ComparisonJob& job, const model::Tree& tree, ComparisonRow& row);

/// Parses PROCESSOR:METHOD or PROCESSOR:METHOD/COHERENCE, separated by commas. Throws InputError if an
/// element has another form or an unknown name.
std::vector<SoftwareChoice> parse_software_choices(const std::string& list);

}  // namespace csgsim::studies
