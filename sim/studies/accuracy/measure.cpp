#include "sim/studies/accuracy/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/vec3.hpp>
#include <memory>
#include <utility>

#include "host/emit/compile.h"
#include "host/view/projection.h"
#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/facts.h"
#include "sim/functional/clocks.h"
#include "sim/judges/errors.h"
#include "sim/judges/explain.h"
#include "sim/judges/meant.h"
#include "sim/judges/sight.h"
#include "sim/judges/truth.h"
#include "sim/observe/stats_json.h"
#include "sim/session/model/model_request.h"
#include "sim/studies/design/meter.h"

namespace csgsim::studies {

namespace {

/// The finest arithmetic, the reference for comparing pictures.
constexpr unsigned finest_z_bits = 24;
constexpr unsigned finest_fraction_bits = 16;

/// Unique text of a faceting. Per solid, a 1 marks one that is faceted although the others are not.
std::string name_of(const facet::Faceting& faceting) {
  std::string name = faceting.exact_curves ? faceting.fast_spheres ? "fast, " : "exact, " : "";
  if (faceting.tolerance) {
    name += fmt::format("tolerance {}", *faceting.tolerance);
  } else {
    name += faceting.fragments ? fmt::format("fn {}", *faceting.fragments) : "openscad";
  }
  for (const bool is_faceted : faceting.faceted) name += is_faceted ? '1' : '0';
  return name;
}

isa::Program compile(const model::Tree& tree, const facet::Geometry& scene, const view::Camera& camera,
                     const view::Sampling& sampling, const machines::Machine& machine, const emit::Options& options) {
  const view::View view = view::make_view(scene, tree, camera, sampling);
  return emit::compile(tree, scene, view, machine, options,
                       [&](const isa::Program& program) { return functional::measure_clocks(program, machine); });
}

machines::Machine with_picture_size(machines::Machine machine, const view::Sampling& sampling) {
  machines::set_picture_size(machine, {sampling.width, sampling.height});
  return machine;
}

/// Sum of the absolute differences of all colour channels over all pixels; colours have `bits` bits.
double colour_difference(const observe::Frame& a, const observe::Frame& b, unsigned bits) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < a.colour.size(); ++i) {
    if (a.colour[i] == b.colour[i]) continue;
    const std::array<std::uint8_t, 3> of_a = isa::unpack_colour(a.colour[i], bits);
    const std::array<std::uint8_t, 3> of_b = isa::unpack_colour(b.colour[i], bits);
    for (std::size_t channel = 0; channel < of_a.size(); ++channel)
      sum += static_cast<std::uint64_t>(std::abs(int{of_a[channel]} - int{of_b[channel]}));
  }
  return static_cast<double>(sum);
}

}  // namespace

struct Meter::Subject {
  facet::Geometry scene;
  std::unique_ptr<const judges::Sight> sight;  ///< visibility of the scene
  judges::Truth exact;                         ///< truth for the half-spaces
  judges::Truth analytic;                      ///< truth for the curved surfaces
  observe::Frame finest;
};

Meter::Meter(const model::Tree& tree, std::vector<view::Camera> cameras, const machines::Machine& machine,
             const emit::Options& options)
    : tree_(tree), cameras_(std::move(cameras)), machine_(machine), options_(options) {}

Meter::~Meter() = default;

namespace {

/// Replaces the settings' arithmetic by the finest.
view::Sampling with_finest_arithmetic(view::Sampling sampling) {
  sampling.z_bits = finest_z_bits;
  sampling.fraction_bits = finest_fraction_bits;
  return sampling;
}

/// Facets those curved solids whose quadrics, in camera space, exceed the machine's number range with the settings or
/// with the finest arithmetic.
facet::Faceting fitting_faceting(const model::Tree& tree, const Settings& settings, const view::Camera& camera) {
  facet::Faceting faceting = settings.faceting;
  if (!faceting.exact_curves) return faceting;
  const facet::Geometry scene = facet::make_geometry(tree, faceting);
  faceting.faceted.resize(scene.solids.size());
  for (const view::Sampling& sampling : {settings.sampling, with_finest_arithmetic(settings.sampling)}) {
    const view::View view = view::make_view(scene, tree, camera, sampling);
    const auto is_unfit = [&](const facet::QuadricSide& side) {
      return view.quadrics[side.quadric].kind == view::ScreenQuadricKind::unfit;
    };
    for (std::size_t i = 0; i < scene.solids.size(); ++i)
      faceting.faceted[i] = faceting.faceted[i] || std::ranges::any_of(scene.solids[i].quadrics, is_unfit);
  }
  return faceting;
}

}  // namespace

Meter::Subject& Meter::subject(const Settings& settings, std::size_t camera) {
  const view::Sampling& sampling = settings.sampling;
  const facet::Faceting faceting = fitting_faceting(tree_, settings, cameras_[camera]);
  const std::string key = fmt::format("{} {}x{} {}", name_of(faceting), sampling.width, sampling.height, camera);
  const auto known = subjects_.find(key);
  if (known != subjects_.end()) return *known->second;

  facet::Geometry scene = facet::make_geometry(tree_, faceting);
  machines::Machine machine = with_picture_size(machine_, sampling);
  machine.array.memory_bits = std::max(machine.array.memory_bits, session::ample_memory_bits);
  DrawnProgram drawn =
      draw(compile(tree_, scene, cameras_[camera], with_finest_arithmetic(sampling), machine, options_), machine);
  const isa::DepthScale depth = drawn.program.facts->depth_scale;
  auto made = std::make_unique<Subject>(Subject{std::move(scene), nullptr, {}, {}, std::move(drawn.frame)});
  made->sight = std::make_unique<judges::Sight>(made->scene, cameras_[camera], sampling.width, sampling.height, depth);
  made->exact = judges::exact_truth(tree_, made->scene, *made->sight);
  made->analytic = analytic(faceting, sampling, camera).truth(depth);
  return *subjects_.emplace(key, std::move(made)).first->second;
}

judges::AnalyticPictures& Meter::analytic(const facet::Faceting& faceting, const view::Sampling& sampling,
                                          std::size_t camera) {
  const std::string key =
      fmt::format("{} {}x{} {}", judges::min_round_fragments(faceting), sampling.width, sampling.height, camera);
  return analytic_.try_emplace(key, tree_, faceting, cameras_[camera], sampling.width, sampling.height).first->second;
}

std::uint64_t Meter::clocks(const Settings& settings) {
  const machines::Machine machine = with_picture_size(machine_, settings.sampling);
  std::uint64_t clocks = 0;
  for (std::size_t camera = 0; camera < cameras_.size(); ++camera) {
    const isa::Program program =
        compile(tree_, subject(settings, camera).scene, cameras_[camera], settings.sampling, machine, options_);
    clocks += functional::measure_clocks(program, machine);
  }
  return clocks;
}

Measurement Meter::measure(const Settings& settings) {
  const auto is_same = [&](const auto& known) {
    return known.first.faceting == settings.faceting && known.first.sampling == settings.sampling;
  };
  const auto known = std::ranges::find_if(known_, is_same);
  Measurement measurement = known == known_.end() ? measure_uncached(settings) : known->second;
  measurement.knob = settings.knob;
  measurement.value = settings.value;
  if (known == known_.end()) known_.emplace_back(settings, measurement);
  return measurement;
}

Measurement Meter::measure_uncached(const Settings& settings) {
  const machines::Machine machine = with_picture_size(machine_, settings.sampling);
  Measurement sum;
  double difference = 0;
  for (std::size_t camera = 0; camera < cameras_.size(); ++camera) {
    const Subject& subject = this->subject(settings, camera);
    const DrawnProgram drawn =
        draw(compile(tree_, subject.scene, cameras_[camera], settings.sampling, machine, options_), machine);
    const judges::Explainer explainer(tree_, subject.scene, *subject.sight, drawn.program);
    const judges::Errors errors = judges::judge(subject.exact, drawn.frame, drawn.program, explainer);
    const judges::Errors facets = judges::compare(subject.analytic, drawn.frame, drawn.program);
    sum.clocks += drawn.timing.clocks;
    sum.halfspaces = std::max(sum.halfspaces, drawn.program.facts->model.halfspaces);
    sum.used_bits = std::max(sum.used_bits, observe::used_memory_bits(drawn.program));
    sum.covered += errors.covered;
    sum.wrong += errors.wrong();
    sum.wrong_silhouette += errors.silhouette;
    sum.wrong_owner += errors.owner;
    sum.unexplained += errors.unexplained;
    sum.depth_max = std::max(sum.depth_max, errors.model_units.max);
    sum.depth_p999 = std::max(sum.depth_p999, errors.model_units.p999);
    sum.depth_max_steps = std::max(sum.depth_max_steps, errors.steps.max);
    sum.depth_p999_steps = std::max(sum.depth_p999_steps, errors.steps.p999);
    sum.facet_wrong += facets.wrong();
    sum.facet_depth_p999 = std::max(sum.facet_depth_p999, facets.model_units.p999);
    difference += colour_difference(drawn.frame, subject.finest, options_.colour_bits) /
                  (3.0 * static_cast<double>(drawn.frame.colour.size()));
  }
  sum.simulated_seconds = static_cast<double>(sum.clocks) / static_cast<double>(machine.clock_hz);
  sum.picture_difference = difference / static_cast<double>(cameras_.size());
  return sum;
}

std::optional<Settings> cheapest_settings(Meter& meter, const std::vector<Settings>& candidates,
                                          std::uint64_t max_wrong_pixels) {
  std::vector<std::pair<std::uint64_t, const Settings*>> by_clocks;
  for (const Settings& candidate : candidates) {
    try {
      by_clocks.emplace_back(meter.clocks(candidate), &candidate);
    } catch (const InputError&) {
      continue;  // does not fit the machine
    }
  }
  std::stable_sort(by_clocks.begin(), by_clocks.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [clocks, candidate] : by_clocks) {
    if (meter.measure(*candidate).wrong <= max_wrong_pixels) return *candidate;
  }
  return std::nullopt;
}

std::vector<view::Camera> rotated_cameras(const view::Camera& camera, unsigned count) {
  constexpr double golden_angle = 2.399963229728653;
  std::vector<view::Camera> cameras;
  for (unsigned i = 0; i < count; ++i) cameras.push_back(view::turned(camera, golden_angle * i));
  return cameras;
}

}  // namespace csgsim::studies
