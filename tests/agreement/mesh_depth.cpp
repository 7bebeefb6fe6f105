#include "tests/agreement/mesh_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace csgsim::testing {

namespace {

/// A corner in the picture: column and row in pixels, and a value linear over the picture (depth or its reciprocal).
struct Corner {
  double x;
  double y;
  double w;
};

void draw_triangle(const std::array<Corner, 3>& t, bool perspective, int size, std::vector<double>& picture) {
  const auto [x_low, x_high] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [y_low, y_high] = std::minmax({t[0].y, t[1].y, t[2].y});
  const int x0 = std::max(static_cast<int>(std::floor(x_low - 0.5)), 0);
  const int x1 = std::min(static_cast<int>(std::ceil(x_high + 0.5)), size);
  const int y0 = std::max(static_cast<int>(std::floor(y_low - 0.5)), 0);
  const int y1 = std::min(static_cast<int>(std::ceil(y_high + 0.5)), size);
  const double area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
  if (area == 0.0) return;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const double dx = x + 0.5 - t[0].x;
      const double dy = y + 0.5 - t[0].y;
      const double b1 = (dx * (t[2].y - t[0].y) - (t[2].x - t[0].x) * dy) / area;
      const double b2 = ((t[1].x - t[0].x) * dy - dx * (t[1].y - t[0].y)) / area;
      if (b1 < -1e-9 || b2 < -1e-9 || b1 + b2 > 1.0 + 1e-9) continue;
      const double w = t[0].w + b1 * (t[1].w - t[0].w) + b2 * (t[2].w - t[0].w);
      double& pixel =
          picture[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)];
      pixel = std::min(pixel, perspective ? 1.0 / w : w);
    }
  }
}

}  // namespace

double diagonal(const Mesh& mesh) {
  glm::dvec3 low = mesh.points.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& point : mesh.points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return glm::length(high - low);
}

std::vector<double> mesh_depth(const Mesh& mesh, const glm::dvec3& eye, const glm::dvec3& centre, bool perspective,
                               int size) {
  const double tangent = std::tan(11.25 * std::acos(-1.0) / 180.0);
  const glm::dvec3 forward = glm::normalize(centre - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double half = tangent * glm::length(centre - eye);
  const auto corner = [&](const glm::dvec3& point) -> Corner {
    const glm::dvec3 d = point - eye;
    const double z = glm::dot(d, forward);
    const double reach = perspective ? z * tangent : half;
    return {(glm::dot(d, right) / reach + 1.0) * size / 2.0, (1.0 - glm::dot(d, up) / reach) * size / 2.0,
            perspective ? 1.0 / z : z};
  };
  std::vector<double> picture(static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                              std::numeric_limits<double>::infinity());
  for (const std::vector<unsigned>& face : mesh.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      draw_triangle({corner(mesh.points[face[0]]), corner(mesh.points[face[i - 1]]), corner(mesh.points[face[i]])},
                    perspective, size, picture);
    }
  }
  return picture;
}

}  // namespace csgsim::testing
