#include "tests/unit/swept/support.h"

#include <fmt/format.h>
#include <rapidcheck.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace csgsim::swept_test {

namespace {

/// Knots of a curve: integers if closed; if open, the ends are repeated degree + 1 times.
double knot_of(const swept::Curve& curve, int i) {
  const int degree = static_cast<int>(curve.degree);
  const int spans = static_cast<int>(curve.points.size()) - (curve.closed ? 0 : degree);
  if (curve.closed) return i - degree;
  return std::min(std::max(i - degree, 0), spans);
}

double basis(const swept::Curve& curve, int i, int degree, double x) {
  const double low = knot_of(curve, i);
  const double high = knot_of(curve, i + degree + 1);
  if (degree == 0) {
    const int spans = static_cast<int>(curve.points.size() - curve.degree);
    const bool is_end = !curve.closed && x == spans && high == spans && low < high;
    return (low <= x && x < high) || is_end ? 1 : 0;
  }
  const double before = knot_of(curve, i + degree);
  const double behind = knot_of(curve, i + 1);
  double sum = 0;
  if (before > low) sum += (x - low) / (before - low) * basis(curve, i, degree - 1, x);
  if (high > behind) sum += (high - x) / (high - behind) * basis(curve, i + 1, degree - 1, x);
  return sum;
}

double uniform_cubic(double x) {
  const double t = std::abs(x);
  if (t >= 2) return 0;
  return t >= 1 ? std::pow(2 - t, 3) / 6 : (4 - 6 * t * t + 3 * t * t * t) / 6;
}

}  // namespace

glm::dvec3 by_basis(const swept::Curve& curve, double parameter) {
  glm::dvec3 sum(0);
  const std::size_t count = curve.points.size() + (curve.closed ? curve.degree : 0);
  for (std::size_t i = 0; i < count; ++i)
    sum += basis(curve, static_cast<int>(i), static_cast<int>(curve.degree), parameter) *
           curve.points[i % curve.points.size()];
  return sum;
}

glm::dvec3 by_basis(const swept::Net& net, double u, double v) {
  glm::dvec3 sum(0);
  for (std::size_t row = 0; row < net.rows.size(); ++row) {
    for (std::size_t column = 0; column < net.rows[row].size(); ++column)
      sum += uniform_cubic(u + 1 - static_cast<double>(column)) * uniform_cubic(v + 1 - static_cast<double>(row)) *
             net.rows[row][column];
  }
  return sum;
}

swept::Net random_net(std::uint32_t rows, std::uint32_t columns, double height) {
  swept::Net net;
  for (std::uint32_t row = 0; row < rows; ++row) {
    std::vector<glm::dvec3>& points = net.rows.emplace_back();
    for (std::uint32_t column = 0; column < columns; ++column)
      points.emplace_back(10.0 * column, 10.0 * row, height * *rc::gen::inRange(-100, 101) / 100);
  }
  return net;
}

std::vector<swept::Element> leaves_of(swept::Surface& surface, std::size_t column, std::size_t row,
                                      const swept::Accuracy& accuracy) {
  swept::SubdivisionCounts counts;
  const std::unique_ptr<swept::Stream> stream = surface.subdivide(column, row, accuracy, counts);
  std::vector<swept::Element> leaves;
  while (const std::optional<swept::Node> node = stream->next()) {
    if (node->is_leaf) leaves.push_back(node->element);
  }
  return leaves;
}

void Record::vertex(std::uint32_t number, const glm::dvec3& point) {
  if (!points.emplace(number, point).second) fault = fmt::format("vertex {} came twice", number);
}

std::string open_edge(const std::vector<std::vector<std::uint32_t>>& faces) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const std::vector<std::uint32_t>& face : faces) {
    for (std::size_t i = 0; i < face.size(); ++i) ++edges[{face[i], face[(i + 1) % face.size()]}];
  }
  for (const auto& [edge, times] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (times != 1 || back == edges.end()) return fmt::format("{}-{}: {} times", edge.first, edge.second, times);
  }
  return "";
}

double volume(const solids::Mesh& mesh) {
  double sum = 0;
  for (const std::vector<std::uint32_t>& face : mesh.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      sum += glm::dot(mesh.points[face[0]], glm::cross(mesh.points[face[i]], mesh.points[face[i + 1]])) / 6;
  }
  return sum;
}

}  // namespace csgsim::swept_test
