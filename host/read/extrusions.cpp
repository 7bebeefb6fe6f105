#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "host/flat/combine.h"
#include "host/read/node_readers.h"
#include "host/read/shared_arguments.h"
#include "host/solids/extrusion.h"
#include "hw/base/error.h"

namespace csgsim::read {

namespace {

constexpr double max_slices = 1'000'000;

constexpr InputKind drawing_file{"a drawing, .dxf", max_file_bytes, "make it coarser"};

/// The number of slices; 0 if it is to be derived from $fn, $fa and $fs.
std::uint32_t read_slices(const Arguments& arguments) {
  const double slices = arguments.number("slices").value_or(0);
  if (!(slices <= max_slices)) arguments.fail("more than {} slices; use fewer", max_slices);
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

/// The area drawn by the argument `file`, which only old files have; empty if there is none.
std::optional<flat::Area> drawn(const Arguments& arguments, double scale) {
  if (!arguments.has("file")) return std::nullopt;
  const std::optional<ImportedFile> file = arguments.file(drawing_file);
  if (!file) return flat::Area{};
  try {
    return dxf_area(arguments, file->bytes, scale);
  } catch (const InputError& error) {
    arguments.fail("{}", error.what());
  }
}

/// The area to be extruded: the file's area if there is a file, otherwise the union of the children. Empty if
/// has_area() is false.
std::optional<flat::Area> extruded_area(const std::optional<flat::Area>& drawn, const Operands& operands) {
  if (drawn) return drawn;
  if (!has_area(operands)) return std::nullopt;
  return union_of_areas(operands);
}

/// Charges the division of an area into convex parts and the extrusion of these.
void charge_extrusion(const flat::Area& area, const Work& work) {
  constexpr std::uint64_t corner_steps = 2'000;
  for (const flat::Outline& outline : area.outlines)
    work.charge(corner_steps * outline.size(), "extruding a 2-D shape");
}

NodeResult extruded(const flat::Area& area, const solids::LinearExtrude& extrusion, const Work& work) {
  charge_extrusion(area, work);
  if (std::optional<solids::HoledPrism> prism = solids::make_holed_prism(area, extrusion)) {
    return {{std::move(prism->whole)}, {}, std::move(prism->holes), 3};
  }
  return {solids::linear_extrude(area, extrusion, work), {}, {}, 3};
}

/// Warns if the file name is a number: OpenSCAD reads the first unnamed argument as a file name, although
/// rotate_extrude(180) is meant as an angle.
void warn_if_number(const Arguments& arguments) {
  const std::optional<ValueView> value = arguments.find("file");
  if (!value || !value->is(ValueKind::string)) return;
  const std::string name = arguments.text("file").value_or("");
  if (name.empty() || name.find_first_not_of("0123456789.-") != std::string::npos) return;
  arguments.warn_once(
      "warning: rotate_extrude() reads a file named {0}; to rotate by an angle, name it: rotate_extrude(angle = {0})",
      shown(name));
}

}  // namespace

Maker read_linear_extrude(const Arguments& arguments) {
  solids::LinearExtrude extrusion;
  extrusion.height = arguments.number("height").value_or(extrusion.height);
  extrusion.center = arguments.boolean("center").value_or(extrusion.center);
  extrusion.twist = arguments.number("twist").value_or(extrusion.twist);
  extrusion.slices = read_slices(arguments);
  extrusion.scale = read_scale(arguments);
  extrusion.facets = read_facets(arguments);
  if (!std::isfinite(extrusion.height) || !std::isfinite(extrusion.twist) || !std::isfinite(extrusion.scale.x) ||
      !std::isfinite(extrusion.scale.y)) {
    arguments.fail("height, twist and scale of linear_extrude() must be finite");
  }
  return [extrusion, file = drawn(arguments, 1)](const Operands& operands) {
    const std::optional<flat::Area> area = extruded_area(file, operands);
    return area ? extruded(*area, extrusion, operands.work) : NodeResult{};
  };
}

Maker read_rotate_extrude(const Arguments& arguments) {
  solids::RotateExtrude extrusion;
  extrusion.angle = arguments.number("angle").value_or(extrusion.angle);
  if (!std::isfinite(extrusion.angle)) extrusion.angle = 360;
  extrusion.facets = read_facets(arguments);
  warn_if_number(arguments);
  const double scale = arguments.has("file") ? arguments.number("scale").value_or(1) : 1;
  return [extrusion, file = drawn(arguments, scale)](const Operands& operands) {
    const std::optional<flat::Area> area = extruded_area(file, operands);
    if (!area || extrusion.angle == 0) return NodeResult{};
    charge_extrusion(*area, operands.work);
    return NodeResult{solids::rotate_extrude(*area, extrusion), {}, {}, 3};
  };
}

}  // namespace csgsim::read
