#include "sim/studies/accuracy/settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/facet/curved.h"

namespace csgsim::studies {

namespace {

constexpr unsigned z_bits[] = {8, 10, 12, 14, 16, 18, 20, 22, 24};
constexpr unsigned fraction_bits[] = {0, 2, 4, 6, 8, 10, 12, 14, 16};
constexpr double edge_on[] = {1.0 / 4, 1.0 / 16, 1.0 / 64, 1.0 / 256, 1.0 / 1024, 1.0 / 4096};
constexpr unsigned size_parts[] = {8, 4, 2, 1};
constexpr unsigned fragments[] = {8, 16, 32, 64, 128};
constexpr double tolerance_parts[] = {1e-2, 3e-3, 1e-3, 3e-4, 1e-4};

constexpr unsigned grid_z_bits[] = {10, 12, 14, 16, 18, 20};
constexpr unsigned grid_fraction_bits[] = {2, 4, 6, 8, 10, 12};

facet::Faceting as_facets(const facet::Faceting& base) {
  facet::Faceting faceting = base;
  faceting.exact_curves = false;
  faceting.fast_spheres = false;
  faceting.faceted.clear();
  return faceting;
}

facet::Faceting as_fast_spheres(const facet::Faceting& base) {
  facet::Faceting faceting = as_facets(base);
  faceting.exact_curves = true;
  faceting.fast_spheres = true;
  return faceting;
}

facet::Faceting as_quadrics(const facet::Faceting& base) {
  facet::Faceting faceting = as_facets(base);
  faceting.exact_curves = true;
  return faceting;
}

std::optional<std::string> no_reason(const CurvesSubject& /*subject*/) { return std::nullopt; }

std::optional<std::string> why_no_fast_spheres(const CurvesSubject& subject) {
  if (subject.camera.projection == view::Projection::perspective)
    return "a fast sphere is seen as a circle, and in a perspective picture spheres are ellipses; take --projection "
           "ortho";
  const facet::Faceting fast = as_fast_spheres({});
  const bool has_sphere = std::ranges::any_of(
      subject.tree.primitives, [&](const model::Primitive& primitive) { return facet::stays_curved(primitive, fast); });
  if (!has_sphere) return "the model has no sphere that is seen as a circle";
  return emit::why_no_curves(subject.machine, subject.options, subject.look);
}

std::optional<std::string> why_no_quadrics(const CurvesSubject& subject) {
  return emit::why_no_quadrics(subject.machine, subject.options, subject.look);
}

constexpr CurvesChoice choices_of_curves[] = {
    {emit::Curves::facets, as_facets, no_reason},
    {emit::Curves::fast, as_fast_spheres, why_no_fast_spheres},
    {emit::Curves::exact, as_quadrics, why_no_quadrics},
};

/// Adds points of one knob.
class Turner {
 public:
  Turner(const char* knob, const view::Sampling& base, const facet::Faceting& faceting, std::vector<Settings>& settings)
      : knob_(knob), base_(base), faceting_(faceting), settings_(settings) {}

  /// As the user has it, but for what is changed in what is returned.
  Settings& operator()(std::string value) const {
    return settings_.emplace_back(Settings{knob_, std::move(value), faceting_, base_});
  }

  [[nodiscard]] const view::Sampling& base() const { return base_; }
  [[nodiscard]] const facet::Faceting& faceting() const { return faceting_; }
  [[nodiscard]] std::vector<Settings>& settings() const { return settings_; }

 private:
  const char* knob_;
  const view::Sampling& base_;
  const facet::Faceting& faceting_;
  std::vector<Settings>& settings_;
};

void turn_z_bits(const Turner& add, const Knobs& /*turned*/) {
  for (const unsigned bits : z_bits) add(std::to_string(bits)).sampling.z_bits = bits;
}

void turn_fraction_bits(const Turner& add, const Knobs& /*turned*/) {
  for (const unsigned bits : fraction_bits) add(std::to_string(bits)).sampling.fraction_bits = bits;
}

void turn_edge_on(const Turner& add, const Knobs& /*turned*/) {
  for (const double part : edge_on) add(fmt::format("1/{:.0f}", 1.0 / part)).sampling.edge_on_fraction = part;
}

void turn_size(const Turner& add, const Knobs& /*turned*/) {
  for (const unsigned part : size_parts) {
    const std::uint32_t width = std::max(1U, add.base().width / part);
    const std::uint32_t height = std::max(1U, add.base().height / part);
    view::Sampling& sampling = add(fmt::format("{}x{}", width, height)).sampling;
    sampling.width = width;
    sampling.height = height;
  }
}

void turn_fragments(const Turner& add, const Knobs& /*turned*/) {
  for (const unsigned count : fragments) add(std::to_string(count)).faceting = {std::nullopt, count};
}

void turn_tolerance(const Turner& add, const Knobs& turned) {
  for (const double tolerance : turned.tolerances)
    add(fmt::format("{:g}", tolerance)).faceting = {tolerance, std::nullopt};
}

void turn_curves(const Turner& add, const Knobs& turned) {
  for (const CurvesChoice& choice : turned.curves)
    add(std::string(emit::name_of(choice.curves))).faceting = choice.faceting(add.faceting());
}

void turn_together(const Turner& add, const Knobs& /*turned*/) {
  for (Settings& point : grid(add.base(), add.faceting())) add.settings().push_back(std::move(point));
}

struct Knob {
  const char* name;
  void (*turn)(const Turner& add, const Knobs& turned);
};

constexpr Knob knobs[] = {
    {"z-bits", turn_z_bits},   {"fraction-bits", turn_fraction_bits},
    {"edge-on", turn_edge_on}, {"size", turn_size},
    {"fn", turn_fragments},    {"tolerance", turn_tolerance},
    {"curves", turn_curves},   {"together", turn_together},
};

}  // namespace

std::vector<Settings> grid(const view::Sampling& base, const facet::Faceting& faceting) {
  std::vector<Settings> settings;
  for (const unsigned z : grid_z_bits) {
    for (const unsigned fraction : grid_fraction_bits) {
      Settings point{"together", fmt::format("{}/{}", z, fraction), faceting, base};
      point.sampling.z_bits = z;
      point.sampling.fraction_bits = fraction;
      settings.push_back(std::move(point));
    }
  }
  return settings;
}

std::span<const CurvesChoice> curves_choices() { return choices_of_curves; }

std::vector<std::string> knob_names() {
  std::vector<std::string> names;
  for (const Knob& knob : knobs) names.emplace_back(knob.name);
  return names;
}

std::vector<double> usual_tolerances(double diagonal) {
  std::vector<double> tolerances;
  for (const double part : tolerance_parts) tolerances.push_back(part * diagonal);
  return tolerances;
}

std::vector<Settings> points(const view::Sampling& base, const facet::Faceting& faceting, const Knobs& turned) {
  std::vector<Settings> settings;
  for (const Knob& knob : knobs) {
    if (std::ranges::find(turned.names, knob.name) == turned.names.end()) continue;
    const Turner add{knob.name, base, faceting, settings};
    knob.turn(add, turned);
  }
  return settings;
}

}  // namespace csgsim::studies
