#include "host/solids/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/vec2.hpp>
#include <vector>

#include "host/solids/height_picture.h"
#include "host/solids/read_mesh.h"
#include "host/solids/words.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

struct Heights {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::vector<double> values;  ///< row by row, starting at y = 0
  double floor = 0;

  [[nodiscard]] double at(std::uint32_t row, std::uint32_t column) const {
    return values[std::size_t{row} * columns + column];
  }
};

/// Builds the mesh of a height field. Its points are the corners of the grid, then the centres of the cells, then the
/// corners of the floor along the rim.
class SurfaceMaker {
 public:
  SurfaceMaker(const Heights& heights, bool center) : heights_(heights) {
    if (center) origin_ = {(1.0 - heights.columns) / 2, (1.0 - heights.rows) / 2};
  }

  Mesh operator()() {
    if (heights_.rows < 2 || heights_.columns < 2) return {};
    add_corners();
    for (std::uint32_t row = 0; row + 1 < heights_.rows; ++row) {
      for (std::uint32_t column = 0; column + 1 < heights_.columns; ++column) add_cell(row, column);
    }
    add_walls_and_floor();
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::uint32_t corner(std::uint32_t row, std::uint32_t column) const {
    return row * heights_.columns + column;
  }

  std::uint32_t add(double x, double y, double z) {
    mesh_.points.emplace_back(origin_.x + x, origin_.y + y, z);
    return static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  void add_corners() {
    for (std::uint32_t row = 0; row < heights_.rows; ++row) {
      for (std::uint32_t column = 0; column < heights_.columns; ++column) add(column, row, heights_.at(row, column));
    }
  }

  void add_cell(std::uint32_t row, std::uint32_t column) {
    const std::uint32_t around[] = {corner(row, column), corner(row, column + 1), corner(row + 1, column + 1),
                                    corner(row + 1, column)};
    const double mean = (heights_.at(row, column) + heights_.at(row, column + 1) + heights_.at(row + 1, column) +
                         heights_.at(row + 1, column + 1)) /
                        4;
    const std::uint32_t middle = add(column + 0.5, row + 0.5, mean);
    for (std::size_t i = 0; i < 4; ++i) mesh_.faces.push_back({around[i], around[(i + 1) % 4], middle});
  }

  /// The corners along the rim, counter-clockwise as seen from above.
  [[nodiscard]] std::vector<std::uint32_t> rim() const {
    const std::uint32_t last_row = heights_.rows - 1;
    const std::uint32_t last_column = heights_.columns - 1;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < last_column; ++i) corners.push_back(corner(0, i));
    for (std::uint32_t i = 0; i < last_row; ++i) corners.push_back(corner(i, last_column));
    for (std::uint32_t i = last_column; i > 0; --i) corners.push_back(corner(last_row, i));
    for (std::uint32_t i = last_row; i > 0; --i) corners.push_back(corner(i, 0));
    return corners;
  }

  void add_walls_and_floor() {
    const std::vector<std::uint32_t> top = rim();
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    const auto count = static_cast<std::uint32_t>(top.size());
    for (const std::uint32_t at : top) {
      const glm::dvec3 point = mesh_.points[at];
      mesh_.points.emplace_back(point.x, point.y, heights_.floor);
    }
    std::vector<std::uint32_t> floor;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = (i + 1) % count;
      mesh_.faces.push_back({first + i, first + next, top[next], top[i]});
      floor.push_back(first + count - 1 - i);
    }
    mesh_.faces.push_back(std::move(floor));
  }

  const Heights& heights_;
  glm::dvec2 origin_{0};
  Mesh mesh_;
};

double floor_below(const std::vector<double>& given) {
  double least = 1;
  for (const double height : given) least = std::min(least, height);
  return least - 1;
}

void require_few_heights(std::size_t heights, std::string_view name) {
  if (heights <= max_heights) return;
  throw InputError(fmt::format("{}: more than {} heights; make the grid coarser", name, max_heights));
}

/// Reads rows of numbers, which may differ in length.
std::vector<std::vector<double>> read_rows(std::string_view text, std::string_view name) {
  Words words(text, name);
  std::vector<std::vector<double>> rows;
  std::size_t count = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word.starts_with('#')) {
      words.skip_line();
      continue;
    }
    std::vector<double>& row = rows.emplace_back();
    for (; !word.empty(); word = words.next_on_line()) {
      row.push_back(words.number_of(word, "a height"));
      require_few_heights(++count, name);
    }
  }
  return rows;
}

}  // namespace

Mesh parse_surface(std::string_view text, std::string_view name, bool center) {
  const std::vector<std::vector<double>> rows = read_rows(text, name);
  Heights heights;
  heights.rows = static_cast<std::uint32_t>(rows.size());
  std::size_t columns = 0;
  for (const auto& row : rows) {
    columns = std::max(columns, row.size());
    heights.floor = std::min(heights.floor, floor_below(row));
  }
  require_few_heights(columns * rows.size(), name);
  heights.columns = static_cast<std::uint32_t>(columns);
  for (const auto& row : rows) {
    heights.values.insert(heights.values.end(), row.begin(), row.end());
    heights.values.resize(heights.values.size() + columns - row.size(), 0);
  }
  return SurfaceMaker(heights, center)();
}

Mesh parse_surface_png(std::string_view bytes, std::string_view name, bool center, bool invert) {
  const Pixels pixels = read_png(bytes, name, max_heights);
  Heights heights{pixels.width, pixels.height, {}, 0};
  for (std::uint32_t row = 0; row < pixels.height; ++row) {
    const unsigned char* pixel = &pixels.bytes[std::size_t{3} * pixels.width * (pixels.height - 1 - row)];
    for (std::uint32_t column = 0; column < pixels.width; ++column, pixel += 3) {
      const double luminance = 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
      heights.values.push_back(100.0 / 255 * (invert ? 1 - luminance : luminance));
    }
  }
  heights.floor = floor_below(heights.values);
  return SurfaceMaker(heights, center)();
}

Mesh parse_surface_file(std::string_view bytes, const std::filesystem::path& path, bool center, bool invert) {
  return lower_case_extension(path) == ".png" ? parse_surface_png(bytes, path.native(), center, invert)
                                              : parse_surface(bytes, path.native(), center);
}

}  // namespace csgsim::solids
