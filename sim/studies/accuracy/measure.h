// Measures clocks and errors of one model with different settings.
// Used by accuracy and by choose_bits.cpp.
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

/// Measures points of one model. Exact pictures are computed once per faceting and size, and points with equal settings
/// are measured once.
class Meter {
 public:
  /// `cameras` are the views of every point; `options` apply to all Programs.
  Meter(const model::Tree& tree, std::vector<view::Camera> cameras, const machines::Machine& machine,
        const emit::Options& options);
  ~Meter();
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  Measurement measure(const Settings& settings);

  /// Clocks of the settings, summed over all views; draws no picture.
  std::uint64_t clocks(const Settings& settings);

 private:
  /// Data for one faceting, size and view, independent of the machine's arithmetic.
  struct Subject;
  Subject& subject(const Settings& settings, std::size_t camera);
  judges::AnalyticPictures& analytic(const facet::Faceting& faceting, const view::Sampling& sampling,
                                     std::size_t camera);
  [[nodiscard]] Measurement measure_uncached(const Settings& settings);

  const model::Tree& tree_;
  std::vector<view::Camera> cameras_;
  machines::Machine machine_;
  emit::Options options_;
  std::map<std::string, std::unique_ptr<Subject>> subjects_;
  std::map<std::string, judges::AnalyticPictures> analytic_;  ///< shared by facetings of the same curved surfaces
  std::vector<std::pair<Settings, Measurement>> known_;
};

/// The settings with the fewest clocks among those with at most `max_wrong_pixels` wrong pixels; empty if there are
/// none. Settings that do not fit into the machine's memory are skipped.
std::optional<Settings> cheapest_settings(Meter& meter, const std::vector<Settings>& candidates,
                                          std::uint64_t max_wrong_pixels);

/// `count` views of a model: the camera rotated about the vertical axis through its centre, by the golden angle each
/// time.
std::vector<view::Camera> rotated_cameras(const view::Camera& camera, unsigned count);

}  // namespace csgsim::studies
