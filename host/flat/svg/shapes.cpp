#include "host/flat/svg/shapes.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "host/flat/svg/numbers.h"
#include "host/flat/svg/path.h"
#include "host/flat/svg/stroke.h"
#include "hw/base/error.h"

namespace csgsim::flat::svg {

namespace {

/// Strokes thinner than this, or with an invalid width, are 1 wide.
constexpr double min_stroke_width = 0.01;

/// Smaller corner radii are treated as 0.
constexpr double min_corner_radius = 1e-8;

struct Element {
  pugi::xml_node node;

  /// The attribute's value, or 0 if it is not a number.
  [[nodiscard]] double number(const char* name) const {
    return parse_single_number(node.attribute(name).value()).value_or(0);
  }

  [[nodiscard]] glm::dvec2 point(const char* x, const char* y) const { return {number(x), number(y)}; }
};

/// The value of a property in the style attribute; empty if absent.
std::string_view style(pugi::xml_node node, std::string_view property) {
  std::string_view rest = node.attribute("style").value();
  while (!rest.empty()) {
    const std::string_view item = rest.substr(0, rest.find(';'));
    rest.remove_prefix(std::min(rest.size(), item.size() + 1));
    if (item.starts_with(property) && item.substr(property.size()).starts_with(':')) {
      return item.substr(property.size() + 1);
    }
  }
  return {};
}

std::string_view presentation(pugi::xml_node node, const char* property) {
  const std::string_view attribute = node.attribute(property).value();
  return attribute.empty() ? style(node, property) : attribute;
}

Stroke stroke(pugi::xml_node node) {
  Stroke result;
  const double width = parse_single_number(presentation(node, "stroke-width")).value_or(0);
  if (width >= min_stroke_width) result.width = width;
  const std::string_view cap = presentation(node, "stroke-linecap");
  if (cap == "butt") result.cap = Cap::butt;
  if (cap == "round") result.cap = Cap::round;
  const std::string_view join = presentation(node, "stroke-linejoin");
  if (join == "bevel") result.join = Join::bevel;
  if (join == "round") result.join = Join::round;
  return result;
}

Outline points(pugi::xml_node node) {
  Outline outline;
  Numbers rest(node.attribute("points").value());
  rest.skip_separators();
  while (!rest.at_end()) {
    const std::optional<double> x = rest.number();
    rest.skip_separators();
    if (x && rest.at_end()) break;
    const std::optional<double> y = rest.number();
    rest.skip_separators();
    if (!x || !y)
      throw InputError("points of a " + std::string(node.name()) + " are not pairs of numbers; correct them");
    outline.emplace_back(*x, *y);
  }
  return outline;
}

Outline rectangle(const Element& element) {
  const glm::dvec2 low = element.point("x", "y");
  const glm::dvec2 size = element.point("width", "height");
  glm::dvec2 radii = element.point("rx", "ry");
  const bool has_x = std::abs(radii.x) >= min_corner_radius;
  const bool has_y = std::abs(radii.y) >= min_corner_radius;
  if (!has_x && !has_y) return {low, {low.x + size.x, low.y}, low + size, {low.x, low.y + size.y}};
  if (!has_x) radii.x = radii.y;
  if (!has_y) radii.y = radii.x;
  return rounded_rectangle(low, size, {std::min(radii.x, size.x / 2), std::min(radii.y, size.y / 2)});
}

}  // namespace

std::optional<std::vector<Outline>> read_shape(pugi::xml_node element, std::size_t max_corners) {
  using Outlines = std::vector<Outline>;
  const std::string_view name = element.name();
  const Element here{element};
  if (name == "path") return read_path(element.attribute("d").value(), stroke(element), max_corners);
  if (name == "rect") return Outlines{rectangle(here)};
  if (name == "circle") return Outlines{ellipse(here.point("cx", "cy"), glm::dvec2(here.number("r")))};
  if (name == "ellipse") return Outlines{ellipse(here.point("cx", "cy"), here.point("rx", "ry"))};
  if (name == "polygon") return Outlines{points(element)};
  if (name == "polyline") return stroke_outlines(points(element), stroke(element), max_corners);
  if (name == "line") {
    return stroke_outlines({here.point("x1", "y1"), here.point("x2", "y2")}, stroke(element), max_corners);
  }
  return std::nullopt;
}

}  // namespace csgsim::flat::svg
