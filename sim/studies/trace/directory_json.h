// Export of facets and of a spatial directory.
// Used by csgsim trace --json.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "sim/studies/json_export.h"
#include "sim/studies/trace/measure.h"

namespace csgsim::studies {

/// Writes the facets of a model (primitive and corners in model space), and the parts into which a directory divides
/// their bounding box. `directory_name` names the kind of directory. A part is either split at `wall` on `axis` into
/// the parts `low` and `high`, or a cell with `facets`. Parts and facets are given by index. A cell holds the facets
/// within `reach` of its box.
void write_directory_json(const JsonExport& json, std::span<const std::filesystem::path> inputs,
                          const TraceSubject& subject, const std::string& directory_name, std::uint32_t bucket_size);

}  // namespace csgsim::studies
