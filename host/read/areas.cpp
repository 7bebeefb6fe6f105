#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "host/flat/combine.h"
#include "host/flat/made.h"
#include "host/flat/offset.h"
#include "host/flat/text.h"
#include "host/read/node_readers.h"
#include "host/read/shared_arguments.h"
#include "hw/base/error.h"
#include "hw/base/text.h"

namespace csgsim::read {

namespace {

/// Returns the maker of a node without children.
Maker leaf(flat::Area area) {
  return [area = std::move(area)](const Operands& /*none*/) { return NodeResult{{}, area, {}, 2}; };
}

std::vector<std::vector<std::uint32_t>> read_paths(const Arguments& arguments, std::size_t points) {
  std::vector<std::vector<std::uint32_t>> paths;
  const std::optional<ValueView> list = arguments.find("paths");
  if (!list) return paths;
  if (!list->is(ValueKind::vector)) arguments.fail(*list, "paths of polygon() must be a vector of paths");
  IndexReader reader(arguments, points);
  bool is_one = list->size() > 0;
  list->for_each([&](ValueView value) { is_one = is_one && !value.is(ValueKind::vector); });
  if (is_one) return {reader.read(*list)};
  list->for_each([&](ValueView value) { paths.push_back(reader.read(value)); });
  return paths;
}

/// Warns that fontconfig substitutes a font: fonts are installed by the user, so the result may differ from what the
/// model's author saw. OpenSCAD does not warn.
void warn_of_replacement(const Arguments& arguments, const flat::Text& text) {
  if (text.text.empty()) return;
  try {
    if (const std::optional<std::string> family = flat::replacement_font(text.font)) {
      arguments.warn_once(
          "warning: the font {} of text() is not installed, and {} is drawn instead, as OpenSCAD does; install it, or "
          "name one that fc-list shows",
          printable(shown(text.font)), printable(*family));
    }
  } catch (const InputError&) {
    // The text module is missing; flat::text() reports this.
  }
}

}  // namespace

Maker read_square(const Arguments& arguments) {
  const ValueView size = arguments.required("size", "size = [x, y]");
  std::array<double, 2> sides{};
  if (size.is(ValueKind::number)) {
    sides.fill(size.value().number);
  } else {
    arguments.read_numbers(size, 2, sides, "size");
  }
  return leaf(flat::square({sides[0], sides[1]}, arguments.boolean("center").value_or(false)));
}

Maker read_circle(const Arguments& arguments) {
  const std::optional<double> radius = read_radius(arguments, "r", "d");
  if (!radius) arguments.fail("circle() lacks its r; add r = radius");
  return leaf(flat::circle(*radius, read_facets(arguments)));
}

Maker read_polygon(const Arguments& arguments) {
  if (arguments.is_undefined("points")) return leaf({});
  const std::optional<std::vector<glm::dvec2>> points = read_points<2>(arguments, "polygon", "it is empty");
  if (!points) return leaf({});
  return [points = *points, paths = read_paths(arguments, points->size())](const Operands& operands) {
    return NodeResult{{}, flat::polygon(points, paths, operands.work), {}, 2};
  };
}

Maker read_text(const Arguments& arguments) {
  flat::Text text;
  const auto take = [&](const char* name, std::string& into) { into = arguments.text(name).value_or(into); };
  const auto take_alignment = [&](const char* name, std::string& into) {
    const std::optional<std::string> given = arguments.text(name);
    if (given && *given != "default") into = *given;
  };
  take("text", text.text);
  take("font", text.font);
  take_alignment("halign", text.halign);
  take_alignment("valign", text.valign);
  take("direction", text.direction);
  take("language", text.language);
  take("script", text.script);
  text.size = arguments.number("size").value_or(text.size);
  text.spacing = arguments.number("spacing").value_or(text.spacing);
  text.facets = read_facets(arguments);
  warn_of_replacement(arguments, text);
  return [text](const Operands& /*none*/) { return NodeResult{{}, flat::text(text), {}, 2}; };
}

Maker read_offset(const Arguments& arguments) {
  const std::optional<double> radius = arguments.number("r");
  const std::optional<double> delta = arguments.number("delta");
  if (radius && delta) arguments.fail("r and delta are both given; remove one");
  const bool is_cut = arguments.boolean("chamfer").value_or(false);
  const flat::Corner corner = !delta ? flat::Corner::round : is_cut ? flat::Corner::cut : flat::Corner::sharp;
  const double distance = delta ? *delta : radius.value_or(1);
  return [=, facets = read_facets(arguments)](const Operands& operands) {
    return NodeResult{{},
                      flat::offset(union_of_areas(operands), distance, corner, facets, operands.work),
                      {},
                      has_area(operands) ? 2U : 0U};
  };
}

}  // namespace csgsim::read
