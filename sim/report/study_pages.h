// Common parts of the pages of studies.
// Used by sim/report, sim/app, sim/session and sim/studies.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/report/configuration.h"
#include "sim/report/page.h"

namespace csgsim::report {

/// Context of a study's page, in addition to its points.
struct StudyContext {
  Context context;
  std::string model;               ///< name of the model's file
  std::optional<Picture> picture;  ///< picture of the model
  std::string no_picture;          ///< reason why there is no picture
};

/// A page with the data and the picture of the model, to which the caller adds sections.
Page begin_page(const std::string& title, Json data, const StudyContext& study);
/// Adds the summary of the data, if it has one, and the configuration.
void end_page(Page& page, const StudyContext& study);

/// A section of the plots that are not empty.
Section plots_section(std::span<const plots::Plot> plots);

/// The page of effects.json, with pictures with all effects, without any, and without each.
Page effects_page(const Json& file, std::vector<Picture> pictures, const StudyContext& study);

}  // namespace csgsim::report
