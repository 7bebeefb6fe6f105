// Export of the events of all rays.
// Used by csgsim classify --json.
#pragma once

#include <filesystem>
#include <span>

#include "sim/studies/classify/measure.h"
#include "sim/studies/json_export.h"

namespace csgsim::studies {

/// Writes the events of all rays that intersect a primitive: `pixel` (column and row); `events`, each with its depth in
/// steps, its primitive (counted from 0 in tree order) and whether the ray leaves it; `seen`, the depth and primitive
/// of the visible surface, or null.
void write_events(const JsonExport& json, std::span<const std::filesystem::path> inputs, const Scene& scene);

}  // namespace csgsim::studies
