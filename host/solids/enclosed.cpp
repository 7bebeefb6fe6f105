#include "host/solids/enclosed.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "host/convex/clip.h"
#include "host/convex/face_polygon.h"
#include "host/solids/shells.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

constexpr std::string_view dividing = "dividing the space inside a self-intersecting surface";

/// Cost of clipping one sheet, or of computing its solid angle from a point.
constexpr std::uint64_t sheet_steps = 50;

/// A part of the surface.
struct Sheet {
  facet::Halfspace halfspace;
  std::vector<glm::dvec3> corners;
};

/// A part of space, and the sheets inside it.
struct SheetCell {
  convex::Polytope space;
  std::vector<Sheet> sheets;
};

class EnclosedDivision {
 public:
  EnclosedDivision(const Soup& soup, const facet::PlaneTable& planes, double near, const Limits& limits)
      : soup_(soup), planes_(planes), limits_(limits), near_(near) {}

  std::vector<convex::Polytope> operator()(convex::Polytope space) {
    add({std::move(space), sheets()});
    while (!open_.empty()) {
      SheetCell cell = std::move(open_.back());
      open_.pop_back();
      if (cell.sheets.empty()) {
        keep(std::move(cell.space));
      } else {
        divide(std::move(cell));
      }
    }
    return std::move(pieces_);
  }

 private:
  [[nodiscard]] std::vector<Sheet> sheets() const {
    std::vector<Sheet> result;
    for (const Fragment& fragment : soup_.fragments) {
      Sheet& sheet = result.emplace_back(Sheet{fragment.halfspace, {}});
      for (std::uint32_t i = fragment.begin; i < fragment.end; ++i) sheet.corners.push_back(point(i));
    }
    return result;
  }

  [[nodiscard]] const glm::dvec3& point(std::uint32_t corner) const {
    return soup_.points[soup_.corners[corner].point];
  }

  void add(SheetCell cell) {
    if (cell.space.empty()) return;
    fragments_ += cell.sheets.size();
    if (fragments_ > limits_.max_fragments) {
      throw InputError("the solid's faces are cut into more than " + std::to_string(limits_.max_fragments) +
                       " parts; use fewer faces, or divide the solid");
    }
    open_.push_back(std::move(cell));
  }

  void divide(SheetCell cell) {
    const facet::Halfspace wall = best_wall(cell.sheets);
    limits_.work.charge(2 * (convex::clip_steps(cell.space) + sheet_steps * cell.sheets.size()), dividing);
    SheetCell back{convex::clip(cell.space, wall, planes_), part(cell.sheets, wall)};
    SheetCell front{convex::clip(std::move(cell.space), convex::opposite(wall), planes_),
                    part(cell.sheets, convex::opposite(wall))};
    add(std::move(front));
    add(std::move(back));
  }

  [[nodiscard]] std::vector<Sheet> part(const std::vector<Sheet>& sheets, facet::Halfspace wall) const {
    const facet::Plane plane = convex::outward_plane(wall, planes_);
    std::vector<Sheet> result;
    for (const Sheet& sheet : sheets) {
      if (sheet.halfspace.plane == wall.plane) continue;
      std::vector<glm::dvec3> kept = convex::clipped(sheet.corners, plane, near_);
      if (!kept.empty()) result.push_back({sheet.halfspace, std::move(kept)});
    }
    return result;
  }

  /// The plane of the sheet that cuts the fewest other sheets. If there are many sheets, only a sample is evaluated.
  [[nodiscard]] facet::Halfspace best_wall(const std::vector<Sheet>& sheets) const {
    constexpr std::size_t most = 32;
    const std::size_t step = sheets.size() / most + 1;
    facet::Halfspace best = sheets.front().halfspace;
    std::size_t fewest = sheets.size() + 1;
    for (std::size_t i = 0; i < sheets.size(); i += step) {
      limits_.work.charge(2 * sheet_steps * sheets.size(), dividing);
      const facet::Plane plane = convex::outward_plane(sheets[i].halfspace, planes_);
      const auto cut = static_cast<std::size_t>(std::count_if(sheets.begin(), sheets.end(), [&](const Sheet& sheet) {
        return !convex::clipped(sheet.corners, plane, near_).empty() &&
               !convex::clipped(sheet.corners, {-plane.normal, -plane.offset}, near_).empty();
      }));
      if (cut >= fewest) continue;
      fewest = cut;
      best = sheets[i].halfspace;
    }
    return best;
  }

  /// Keeps a piece if it is inside the surface. No sheet is within the piece, so its centre decides for all of it.
  void keep(convex::Polytope piece) {
    limits_.work.charge(sheet_steps * soup_.fragments.size(), dividing);
    glm::dvec3 middle(0);
    for (const glm::dvec3& vertex : piece.vertices) middle += vertex;
    middle /= static_cast<double>(piece.vertices.size());
    if (std::lround(winding(middle)) == 0) return;
    pieces_.push_back(std::move(piece));
    if (pieces_.size() > limits_.max_pieces) {
      throw InputError("the solid needs more than " + std::to_string(limits_.max_pieces) +
                       " convex pieces; use fewer faces, or divide the solid");
    }
  }

  [[nodiscard]] double winding(const glm::dvec3& from) const {
    double angle = 0;
    for (const Fragment& fragment : soup_.fragments) {
      for_each_triangle(soup_, fragment, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        angle += solid_angle(a - from, b - from, c - from);
      });
    }
    return angle / (4.0 * std::numbers::pi);
  }

  const Soup& soup_;
  const facet::PlaneTable& planes_;
  const Limits& limits_;
  double near_;
  std::size_t fragments_ = 0;  ///< total number of sheets added
  std::vector<SheetCell> open_;
  std::vector<convex::Polytope> pieces_;
};

}  // namespace

std::vector<convex::Polytope> enclosed(const Soup& soup, convex::Polytope cell, const facet::PlaneTable& planes,
                                       double near, const Limits& limits) {
  return EnclosedDivision(soup, planes, near, limits)(std::move(cell));
}

}  // namespace csgsim::solids
