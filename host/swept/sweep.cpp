#include "host/swept/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <glm/geometric.hpp>
#include <utility>

#include "host/swept/flat.h"
#include "host/swept/spine.h"
#include "host/swept/subdivision.h"

namespace csgsim::swept {

namespace {

/// A node of the segment tree of a contour: a part of a segment. Its halves are created on demand.
struct ContourNode {
  Segment segment;
  glm::dvec3 middle{0};
  ContourNode* halves = nullptr;  ///< two nodes
};

/// A node of the segment tree of a trajectory.
struct TrajectoryNode {
  Segment segment;
  std::size_t number = 0;  ///< index of the whole segment
  double from = 0;         ///< start of the parameter range on the whole segment
  double to = 1;
  Section start;
  Section middle;
  Section end;
  bool is_short = true;  ///< see Spine::is_short
  TrajectoryNode* halves = nullptr;
};

/// Maximum distance of the inner Bernstein coefficients from the line between the ends for which the curve stays within
/// 1 of it.
double slack(std::uint32_t degree) { return degree == 2 ? 2 : 4.0 / 3; }

/// Number of additions and halvings that halve a segment whose points have `coordinates` coordinates.
std::uint64_t halves_arithmetic(const Segment& segment, std::uint64_t coordinates) {
  return 2 * coordinates * segment.degree * (segment.degree + 1) / 2;
}

/// Arithmetic of one contour point in a section: two products per coordinate.
constexpr Arithmetic point_arithmetic{6, 6, 0, 0};
/// Arithmetic of one section whose tangent is given: v and u of length 1, rotated and scaled; the length is looked up.
constexpr Arithmetic section_arithmetic{40, 60, 6, 2};

class SweptShape {
 public:
  struct Part {
    ContourNode* contour;
    TrajectoryNode* trajectory;
  };

  explicit SweptShape(const Sweep& sweep) : spine_(sweep) {
    for (const Segment& segment : bernstein_segments(sweep.contour)) contours_.push_back({segment, at(segment, 0.5)});
    for (std::size_t i = 0; i < spine_.segments().size(); ++i) {
      TrajectoryNode& node = trajectories_.emplace_back();
      node.segment = spine_.segments()[i];
      node.number = i;
      node.start = spine_.joint(i);
      node.end = spine_.joint(i + 1);
      find_middle(node);
    }
    columns_ = contours_.size();
    rows_ = trajectories_.size();
  }

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] bool is_closed() const { return spine_.is_closed(); }
  Part whole(std::size_t column, std::size_t row) { return {&contours_[column], &trajectories_[row]}; }

  static std::array<glm::dvec3, 4> corners(const Part& part) {
    const Segment& contour = part.contour->segment;
    const TrajectoryNode& trajectory = *part.trajectory;
    return {trajectory.start.at(contour.first()), trajectory.start.at(contour.last()),
            trajectory.end.at(contour.first()), trajectory.end.at(contour.last())};
  }

  static bool is_flat(const Part& part, const std::array<glm::dvec3, 4>& corners, const Accuracy& accuracy,
                      SubdivisionCounts& counts) {
    ++counts.points;
    for (int i = 0; i < 5; ++i) counts.arithmetic += point_arithmetic;
    const glm::dvec3 middle = part.trajectory->middle.at(part.contour->middle);
    if (!swept::is_flat(corners, middle, accuracy.tolerance, counts)) return false;
    return accuracy.flatness == Flatness::plane ||
           (part.trajectory->is_short && has_straight_sides(part, corners, accuracy.tolerance, counts));
  }

  std::array<Part, 4> parts(const Part& part, SubdivisionCounts& counts) {
    if (part.contour->halves == nullptr) halve(*part.contour, counts);
    if (part.trajectory->halves == nullptr) halve(*part.trajectory, counts);
    ContourNode* const contour = part.contour->halves;
    TrajectoryNode* const trajectory = part.trajectory->halves;
    return {Part{contour, trajectory}, Part{contour + 1, trajectory}, Part{contour, trajectory + 1},
            Part{contour + 1, trajectory + 1}};
  }

 private:
  /// Tests the contour's coefficients in both end sections, and the midpoint along the trajectory.
  static bool has_straight_sides(const Part& part, const std::array<glm::dvec3, 4>& corners, double tolerance,
                                 SubdivisionCounts& counts) {
    const Segment& contour = part.contour->segment;
    const TrajectoryNode& trajectory = *part.trajectory;
    for (std::uint32_t i = 1; i < contour.degree; ++i) {
      const glm::dvec3& inner = contour.coefficients[i];
      counts.tests += 2;
      for (int k = 0; k < 2; ++k) counts.arithmetic += line_arithmetic;
      if (distance_to_segment(trajectory.start.at(inner), corners[sw], corners[se]) >
              slack(contour.degree) * tolerance ||
          distance_to_segment(trajectory.end.at(inner), corners[nw], corners[ne]) > slack(contour.degree) * tolerance)
        return false;
    }
    counts.tests += 2;
    counts.points += 2;
    for (int k = 0; k < 2; ++k) {
      counts.arithmetic += line_arithmetic;
      counts.arithmetic += point_arithmetic;
    }
    if (distance_to_segment(trajectory.middle.at(contour.first()), corners[sw], corners[nw]) > tolerance ||
        distance_to_segment(trajectory.middle.at(contour.last()), corners[se], corners[ne]) > tolerance)
      return false;
    const Segment& spine = trajectory.segment;
    for (std::uint32_t i = 1; i < spine.degree; ++i) {
      ++counts.tests;
      counts.arithmetic += line_arithmetic;
      if (distance_to_segment(spine.coefficients[i], spine.first(), spine.last()) > slack(spine.degree) * tolerance)
        return false;
    }
    return true;
  }

  void find_middle(TrajectoryNode& node) const {
    node.middle = spine_.section(node.number, 0.5 * (node.from + node.to), at(node.segment, 0.5));
    node.is_short = spine_.is_short(node.number, node.from, node.to);
  }

  void halve(ContourNode& node, SubdivisionCounts& counts) {
    ++counts.halvings;
    counts.arithmetic.adds += halves_arithmetic(node.segment, 2);
    const auto [left, right] = halves(node.segment);
    auto& two =
        contour_halves_.emplace_back(std::array{ContourNode{left, at(left, 0.5)}, ContourNode{right, at(right, 0.5)}});
    node.halves = two.data();
  }

  void halve(TrajectoryNode& node, SubdivisionCounts& counts) {
    ++counts.halvings;
    counts.sections += 2;
    counts.arithmetic.adds += halves_arithmetic(node.segment, 3);
    for (int i = 0; i < 2; ++i) counts.arithmetic += section_arithmetic;
    auto [left, right] = halves(node.segment);
    const double middle = 0.5 * (node.from + node.to);
    auto& two = trajectory_halves_.emplace_back(
        std::array{TrajectoryNode{left, node.number, node.from, middle, node.start, {}, node.middle},
                   TrajectoryNode{right, node.number, middle, node.to, node.middle, {}, node.end}});
    for (TrajectoryNode& half : two) find_middle(half);
    node.halves = two.data();
  }

  Spine spine_;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::deque<ContourNode> contours_;
  std::deque<TrajectoryNode> trajectories_;
  std::deque<std::array<ContourNode, 2>> contour_halves_;
  std::deque<std::array<TrajectoryNode, 2>> trajectory_halves_;
};

class SweptSurface : public Surface {
 public:
  explicit SweptSurface(const Sweep& sweep) : shape_(sweep) {}

  [[nodiscard]] std::size_t columns() const override { return shape_.columns(); }
  [[nodiscard]] std::size_t rows() const override { return shape_.rows(); }
  [[nodiscard]] bool wraps_columns() const override { return true; }
  [[nodiscard]] bool wraps_rows() const override { return shape_.is_closed(); }

  std::unique_ptr<Stream> subdivide(std::size_t column, std::size_t row, const Accuracy& accuracy,
                                    SubdivisionCounts& counts) override {
    return std::make_unique<Subdivision<SweptShape>>(shape_, shape_.whole(column, row), accuracy, counts);
  }

 private:
  SweptShape shape_;
};

std::string with_name(const char* name, const std::string& fault) {
  return fault.empty() ? fault : std::string("the ") + name + ": " + fault;
}

}  // namespace

double twice_signed_area(const Curve& contour) {
  double twice = 0;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const glm::dvec3& from = contour.points[i];
    const glm::dvec3& to = contour.points[(i + 1) % contour.points.size()];
    twice += from.x * to.y - to.x * from.y;
  }
  return twice;
}

std::string validation_error(const Sweep& sweep) {
  for (const auto& [name, curve] : {std::pair("contour", &sweep.contour), std::pair("trajectory", &sweep.trajectory),
                                    std::pair("rotation", &sweep.rotation), std::pair("scale", &sweep.scale)}) {
    if (const std::string fault = validation_error(*curve); !fault.empty()) return with_name(name, fault);
  }
  if (!sweep.contour.closed) return "the contour is open; write `closed` in its curve";
  if (sweep.trajectory.degree == 0) return "the trajectory is a point; use degree 1, 2 or 3";
  if (sweep.rotation.closed || sweep.scale.closed) return "rotation and scale cannot be closed; use `open`";
  if (twice_signed_area(sweep.contour) == 0) return "the contour encloses no area; move its points apart";
  if (sweep.contour.points.size() * sweep.trajectory.points.size() > max_patches)
    return fmt::format("contour and trajectory make more than {} patches; remove points", max_patches);
  const auto is_below = [](const glm::dvec3& point) { return point.x < 0 || point.y < 0; };
  if (std::ranges::any_of(sweep.scale.points, is_below))
    return "a scale is below 0, which would turn the solid inside out; use 0 or more";
  return "";
}

std::unique_ptr<Surface> make_surface(const Sweep& sweep) { return std::make_unique<SweptSurface>(sweep); }

}  // namespace csgsim::swept
