#pragma once

#include <filesystem>
#include <span>

#include "sim/studies/classify/measure.h"
#include "sim/studies/json_export.h"

namespace csgsim::studies {

/// Writes the events of all rays that meet anything: `pixel`, column and row; `events`, of each its depth in steps, its
/// primitive, counted from 0 in tree order, and whether it is left; `seen`, the depth and the primitive that is seen,
/// or null.
void write_events(const JsonExport& json, std::span<const std::filesystem::path> inputs, const Scene& scene);

}  // namespace csgsim::studies
