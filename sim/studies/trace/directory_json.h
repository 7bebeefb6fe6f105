#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "sim/studies/json_export.h"
#include "sim/studies/trace/measure.h"

namespace csgsim::studies {

/// Writes the facets of a model, each with its primitive and its corners in model space, and the parts of space that a
/// directory makes of their box: halved by `wall` across `axis` into `low` and `high`, numbers of parts, or a cell with
/// `facets`, numbers of facets. A cell has the facets that are within `reach` of its box.
void write_directory(const JsonExport& json, std::span<const std::filesystem::path> inputs, const TraceSubject& subject,
                     const std::string& directory, std::uint32_t bucket_size);

}  // namespace csgsim::studies
