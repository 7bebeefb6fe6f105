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
#include "sim/studies/design/row.h"

namespace csgsim::studies {

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
