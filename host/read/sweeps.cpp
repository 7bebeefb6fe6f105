#include "host/read/sweeps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "host/flat/combine.h"
#include "host/read/files.h"
#include "host/read/imports.h"
#include "host/read/measures.h"
#include "host/read/only.h"
#include "host/solids/sweep.h"
#include "hw/base/error.h"

namespace csgsim::read {

namespace {

constexpr double most_slices = 1'000'000;

/// A whole number of slices; 0 leaves it to the facets.
std::uint32_t read_slices(const Arguments& arguments) {
  const double slices = arguments.number("slices").value_or(0);
  if (!(slices <= most_slices)) arguments.fail("more than {} slices; ask for fewer", most_slices);
  return static_cast<std::uint32_t>(std::max(slices, 0.0));
}

glm::dvec2 read_scale(const Arguments& arguments) {
  const std::optional<ValueView> scale = arguments.find("scale");
  if (!scale) return glm::dvec2(1);
  if (scale->is(ValueKind::number)) return glm::dvec2(scale->value().number);
  std::array<double, 2> both{1, 1};
  arguments.read_numbers(*scale, 2, both, "scale");
  return {both[0], both[1]};
}

/// What the argument `file` draws: so files of old say what is extruded.
std::vector<flat::Area> drawn(const Arguments& arguments, double scale) {
  if (!arguments.has("file")) return {};
  try {
    return {dxf_area(arguments, file_of(arguments), scale)};
  } catch (const InputError& error) {
    arguments.fail("{}", error.what());
  }
}

flat::Area with(std::vector<flat::Area> drawn, const Operands& operands) {
  drawn.push_back(only_area(operands));
  return flat::unite(drawn);
}

Made extruded(const flat::Area& area, const solids::LinearExtrude& sweep) {
  if (std::optional<solids::HoledPrism> prism = solids::holed_prism(area, sweep)) {
    return {{std::move(prism->whole)}, {}, std::move(prism->holes)};
  }
  return {solids::linear_extrude(area, sweep), {}, {}};
}

}  // namespace

Maker read_linear_extrude(const Arguments& arguments) {
  solids::LinearExtrude sweep;
  sweep.height = arguments.number("height").value_or(sweep.height);
  sweep.center = arguments.boolean("center").value_or(sweep.center);
  sweep.twist = arguments.number("twist").value_or(sweep.twist);
  sweep.slices = read_slices(arguments);
  sweep.scale = read_scale(arguments);
  sweep.facets = read_facets(arguments);
  if (!std::isfinite(sweep.height) || !std::isfinite(sweep.twist) || !std::isfinite(sweep.scale.x) ||
      !std::isfinite(sweep.scale.y)) {
    arguments.fail("height, twist and scale of linear_extrude() must be finite");
  }
  return
      [sweep, areas = drawn(arguments, 1)](const Operands& operands) { return extruded(with(areas, operands), sweep); };
}

Maker read_rotate_extrude(const Arguments& arguments) {
  solids::RotateExtrude sweep;
  sweep.angle = arguments.number("angle").value_or(sweep.angle);
  if (!std::isfinite(sweep.angle)) sweep.angle = 360;
  sweep.facets = read_facets(arguments);
  const double scale = arguments.has("file") ? arguments.number("scale").value_or(1) : 1;
  return [sweep, areas = drawn(arguments, scale)](const Operands& operands) {
    return Made{solids::rotate_extrude(with(areas, operands), sweep), {}};
  };
}

}  // namespace csgsim::read
