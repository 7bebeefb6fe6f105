#include "tests/numerics/solids.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace csgsim::testing {

namespace {

std::string operation(const char* name, std::span<const std::string> parts) {
  std::string text = std::string(name) + "(){\n";
  for (const std::string& part : parts) text += part;
  return text + "}\n";
}

std::span<const std::string> as_span(std::initializer_list<std::string> parts) { return {parts.begin(), parts.size()}; }

}  // namespace

std::string box(const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 size = high - low;
  return with_transform(translation(low), fmt::format("cube(size=[{},{},{}],center=false);", size.x, size.y, size.z));
}

std::string ball(const glm::dvec3& centre, double radius, unsigned fragments) {
  return with_transform(translation(centre), fmt::format("sphere($fn={},$fa=12,$fs=2,r={});", fragments, radius));
}

std::string cylinder(const glm::dvec3& foot, double height, double low_radius, double high_radius, unsigned fragments) {
  return with_transform(translation(foot), fmt::format("cylinder($fn={},$fa=12,$fs=2,h={},r1={},r2={},center=false);",
                                                       fragments, height, low_radius, high_radius));
}

std::string rod(const glm::dvec3& foot, double height, double radius) { return cylinder(foot, height, radius, radius); }

std::string tetrahedron(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  std::string points;
  for (const glm::dvec3& p : {a, b, c, d}) {
    points += fmt::format("{}[{},{},{}]", points.empty() ? "" : ",", p.x, p.y, p.z);
  }
  return fmt::format("polyhedron(points=[{}],faces=[[0,1,2],[0,3,1],[1,3,2],[0,2,3]],convexity=1);\n", points);
}

std::string unite(std::initializer_list<std::string> parts) { return unite(as_span(parts)); }
std::string subtract(std::initializer_list<std::string> parts) { return subtract(as_span(parts)); }
std::string intersect(std::initializer_list<std::string> parts) { return intersect(as_span(parts)); }
std::string unite(std::span<const std::string> parts) { return operation("union", parts); }
std::string subtract(std::span<const std::string> parts) { return operation("difference", parts); }
std::string intersect(std::span<const std::string> parts) { return operation("intersection", parts); }

std::string with_transform(const std::string& matrix, const std::string& csg) {
  return "multmatrix(" + matrix + "){" + csg + "}\n";
}

std::string rotation(double about_x, double about_z) {
  constexpr double radians = std::numbers::pi / 180.0;
  const double sx = std::sin(about_x * radians);
  const double cx = std::cos(about_x * radians);
  const double sz = std::sin(about_z * radians);
  const double cz = std::cos(about_z * radians);
  return fmt::format("[[{},{},{},0],[{},{},{},0],[0,{},{},0],[0,0,0,1]]", cz, -sz * cx, sz * sx, sz, cz * cx, -cz * sx,
                     sx, cx);
}

std::string translation(const glm::dvec3& by) {
  return fmt::format("[[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]", by.x, by.y, by.z);
}

std::string scaling(const glm::dvec3& by) {
  return fmt::format("[[{},0,0,0],[0,{},0,0],[0,0,{},0],[0,0,0,1]]", by.x, by.y, by.z);
}

}  // namespace csgsim::testing
