#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
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

/// Pages of the files of points that studies write (accuracy.json, sweep.json, compare.json). `front` names the points
/// of the Pareto front by their `value`, in order; `views` is how many a point of accuracy was drawn in.
Page accuracy_page(const Json& file, const std::vector<std::string>& front, unsigned views, const StudyContext& study);
Page sweep_page(const Json& file, const StudyContext& study);
Page compare_page(const Json& file, const StudyContext& study);

/// The page of advise.json, without the points that it searched, which are thousands. The pictures are those of what is
/// recommended.
Page advise_page(const Json& file, const plots::Plot& front, std::vector<Picture> pictures, const StudyContext& study);

/// The page of corpus.json, with its plots.
Page corpus_page(const Json& file, std::span<const plots::Plot> plots, const StudyContext& study);

/// The page of effects.json. The pictures are with all effects, with none, and without each.
Page effects_page(const Json& file, std::vector<Picture> pictures, const StudyContext& study);

}  // namespace csgsim::report
