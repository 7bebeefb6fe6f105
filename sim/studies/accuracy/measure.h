#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "hw/machines/machine.h"
#include "sim/judges/analytic.h"
#include "sim/studies/accuracy/settings.h"
#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// What one point costs, and how right its pictures are. Sums over the views; depths are the worst of them.
struct Measurement {
  static constexpr std::size_t point_columns = 2;

  std::string knob;
  std::string value;
  Inputs inputs;
  std::uint64_t clocks = 0;
  double simulated_seconds = 0;
  std::uint64_t halfspaces = 0;
  std::uint32_t used_bits = 0;
  std::uint64_t covered = 0;           ///< pixels
  std::uint64_t wrong = 0;             ///< pixels that differ from the exact picture of the same half-spaces
  std::uint64_t wrong_silhouette = 0;  ///< of these, seen in one of the pictures only
  std::uint64_t wrong_owner = 0;       ///< of these, another primitive seen
  std::uint64_t unexplained = 0;       ///< of these, beyond the bounds that docs/numbers.md states
  double depth_max = 0;                ///< model units
  double depth_p999 = 0;               ///< model units, at most this at 99.9 % of the pixels
  double depth_max_steps = 0;          ///< depth steps
  double depth_p999_steps = 0;         ///< depth steps
  std::uint64_t facet_wrong = 0;       ///< pixels that differ from the true curved surfaces
  double facet_depth_p999 = 0;         ///< model units, from the true curved surfaces
  double picture_difference = 0;       ///< mean difference of the colours from the finest arithmetic's, of 255

  bool operator==(const Measurement&) const = default;

  static void columns(auto& row, const auto& visit) {
    visit("knob", row.knob);
    visit("value", row.value);
    Inputs::columns(row.inputs, visit);
    visit("clocks", row.clocks);
    visit("simulated_seconds", row.simulated_seconds);
    visit("halfspaces", row.halfspaces);
    visit("used_bits", row.used_bits);
    visit("covered", row.covered);
    visit("wrong", row.wrong);
    visit("wrong_silhouette", row.wrong_silhouette);
    visit("wrong_owner", row.wrong_owner);
    visit("unexplained", row.unexplained);
    visit("depth_max", row.depth_max);
    visit("depth_p999", row.depth_p999);
    visit("depth_max_steps", row.depth_max_steps);
    visit("depth_p999_steps", row.depth_p999_steps);
    visit("facet_wrong", row.facet_wrong);
    visit("facet_depth_p999", row.facet_depth_p999);
    visit("picture_difference", row.picture_difference);
  }
};

/// Measures points of one model. Pictures of the exact arithmetic are worked out once for each faceting and size, and
/// points whose settings are the same are measured once.
class Meter {
 public:
  /// `cameras` are the views that a point is measured in, `options` how all of them are compiled.
  Meter(const model::Tree& tree, std::vector<view::Camera> cameras, const machines::Machine& machine,
        const emit::Options& options);
  ~Meter();
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  Measurement measure(const Settings& settings);

  /// Clocks of the settings over all views, without judging any picture.
  std::uint64_t clocks(const Settings& settings);

 private:
  /// What does not depend on the arithmetic: one faceting, one size, one view.
  struct Subject;
  Subject& subject(const Settings& settings, std::size_t camera);
  judges::AnalyticPictures& analytic(const facet::Faceting& faceting, const view::Sampling& sampling,
                                     std::size_t camera);
  [[nodiscard]] Measurement measure_anew(const Settings& settings);

  const model::Tree& tree_;
  std::vector<view::Camera> cameras_;
  machines::Machine machine_;
  emit::Options options_;
  std::map<std::string, std::unique_ptr<Subject>> subjects_;
  std::map<std::string, judges::AnalyticPictures> analytic_;  ///< facetings share what they stand for
  std::vector<std::pair<Settings, Measurement>> known_;
};

/// The settings of a grid that take the fewest clocks of those with at most `most_wrong` wrong pixels; nothing if none
/// has. Settings that the machine's memory does not hold are passed over.
std::optional<Settings> cheapest(Meter& meter, const std::vector<Settings>& candidates, std::uint64_t most_wrong);

/// `count` views of a model: the camera turned about the vertical through its centre, by the golden angle each time.
std::vector<view::Camera> turned_views(const view::Camera& camera, unsigned count);

}  // namespace csgsim::studies
