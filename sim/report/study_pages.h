#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/report/configuration.h"
#include "sim/report/page.h"

namespace csgsim::report {

/// What is told of every study besides its points.
struct StudyContext {
  Context context;
  std::string model;               ///< the name of its file
  std::optional<Picture> picture;  ///< of the model
  std::string no_picture;          ///< why there is none
};

/// A page that begins with the picture and ends with the configuration; what is between them, others add.
Page begun_page(const std::string& title, Json data, const StudyContext& study);
void end_page(Page& page, const StudyContext& study);

/// A section of those among these that have something to show.
Section plots_section(std::span<const plots::Plot> plots);

/// The page of effects.json. The pictures are with all effects, with none, and without each.
Page effects_page(const Json& file, std::vector<Picture> pictures, const StudyContext& study);

}  // namespace csgsim::report
