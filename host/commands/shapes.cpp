#include "host/commands/shapes.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "host/model/limits.h"
#include "hw/base/nearest.h"

namespace csgsim::commands {

namespace {

constexpr double highest_degree = 3;

model::Shape read_block(Cursor& line, const model::FacetControl& /*facets*/) {
  const double x = line.take_positive_number("a block's length along x");
  const double y = line.take_positive_number("a block's length along y");
  return model::Cube{{x, y, line.take_positive_number("a block's length along z")}, false};
}

model::Shape read_cylinder(Cursor& line, const model::FacetControl& facets) {
  const double radius = line.take_positive_number("a cylinder's radius");
  return model::Cylinder{line.take_positive_number("a cylinder's height"), radius, radius, false, facets};
}

model::Shape read_cone(Cursor& line, const model::FacetControl& facets) {
  const double radius = line.take_positive_number("a cone's radius");
  const double height = line.take_positive_number("a cone's height");
  const double top = line.is(Kind::number) ? line.take_positive_number("a cone's radius at its top") : 0;
  return model::Cylinder{height, radius, top, false, facets};
}

model::Shape read_sphere(Cursor& line, const model::FacetControl& facets) {
  return model::Sphere{line.take_positive_number("a sphere's radius"), facets};
}

struct SolidRow {
  std::string_view word;
  model::Shape (*read)(Cursor& line, const model::FacetControl& facets);
};
constexpr std::array solid_rows{SolidRow{"block", read_block}, SolidRow{"cylinder", read_cylinder},
                                SolidRow{"cone", read_cone}, SolidRow{"sphere", read_sphere}};

/// One to three numbers in parentheses.
glm::dvec3 read_point(Cursor& line, std::size_t& numbers) {
  const std::uint32_t offset = line.offset();
  line.expect_symbol("(", "before the numbers of a point");
  const std::vector<double> point = line.numbers();
  line.expect_symbol(")", "after the numbers of a point");
  if (point.empty() || point.size() > 3)
    line.fail(offset, fmt::format("a point must have 1 to 3 numbers, not {}", point.size()));
  if (numbers != 0 && point.size() != numbers)
    line.fail(
        offset,
        fmt::format(
            "this point has a different number of coordinates ({}) than those before it ({}); use the same number",
            point.size(), numbers));
  if (std::ranges::any_of(point, [](double one) { return std::abs(one) > model::max_coordinate; }))
    line.fail(offset,
              fmt::format("the point is farther than {:g} from the origin; move it closer", model::max_coordinate));
  numbers = point.size();
  return {point[0], numbers > 1 ? point[1] : 0, numbers > 2 ? point[2] : 0};
}

}  // namespace

bool is_solid_word(std::string_view word) {
  return std::ranges::any_of(solid_rows, [&](const SolidRow& row) { return row.word == word; });
}

std::string_view similar_solid_word(std::string_view word) {
  std::vector<std::string_view> words;
  words.reserve(solid_rows.size());
  for (const SolidRow& row : solid_rows) words.push_back(row.word);
  return nearest_similar(word, words);
}

model::Shape read_solid(std::string_view word, Cursor& line, const model::FacetControl& facets) {
  return std::ranges::find(solid_rows, word, &SolidRow::word)->read(line, facets);
}

Curve read_curve(Cursor& line) {
  Curve made;
  made.offset = line.offset();
  made.curve.closed = line.take_if("closed");
  if (!made.curve.closed) line.take_if("open");
  if (line.take_if("degree")) {
    const std::uint32_t offset = line.offset();
    const double degree = line.number("a degree: 0 (constant), 1, 2 or 3");
    if (!(degree >= 0 && degree <= highest_degree && degree == std::floor(degree)))
      line.fail(offset, "a degree must be 0 (constant), 1, 2 or 3");
    made.curve.degree = static_cast<std::uint32_t>(degree);
  }
  if (!line.take_if("points")) line.fail_here("expected `closed`, `degree` or `points`, in this order");
  while (!line.at_end()) made.curve.points.push_back(read_point(line, made.numbers));
  if (const std::string fault = swept::validation_error(made.curve); !fault.empty()) line.fail(made.offset, fault);
  return made;
}

swept::Net read_net(Cursor& line) {
  const std::uint32_t begin = line.offset();
  if (!line.take_if("width")) line.fail_here("expected `width` and the number of points in a row");
  const std::uint32_t offset = line.offset();
  const double width = line.number("the number of points in a row");
  constexpr double most = 10'000;
  if (!(width >= 4 && width <= most && width == std::floor(width)))
    line.fail(offset, fmt::format("a row of a patch must have 4 to {} points", most));
  if (!line.take_if("points")) line.fail_here("expected `points`");
  swept::Net net;
  std::size_t numbers = 0;
  while (line.is("(")) {
    if (net.rows.empty() || net.rows.back().size() == static_cast<std::size_t>(width)) net.rows.emplace_back();
    const std::uint32_t place = line.offset();
    net.rows.back().push_back(read_point(line, numbers));
    if (numbers != 3) line.fail(place, "a point of a patch must have three numbers");
  }
  if (const std::string fault = swept::validation_error(net); !fault.empty()) line.fail(begin, fault);
  return net;
}

}  // namespace csgsim::commands
