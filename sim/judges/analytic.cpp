#include "sim/judges/analytic.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "hw/isa/depth_scale.h"
#include "sim/judges/meant.h"
#include "sim/judges/solid_ray.h"
#include "sim/judges/tree_on_ray.h"

namespace csgsim::judges {

namespace {

/// Depths closer than this fraction of the distance are considered equal. It must exceed the distance of planes that
/// the host unifies (facet::coincidence_tolerance, relative to the model's diagonal), with a factor of a hundred for
/// planes seen nearly edge-on: otherwise coinciding faces would have another owner here than in the faceted picture.
constexpr long double same_depth_tolerance = 1e-9L;

/// Offset that moves rays off edge-on faces, pixels.
constexpr long double nudge_right = 1e-9L;
constexpr long double nudge_down = 1e-10L;

/// Minimum sine of the angle between the view and the camera's upward direction; below it, +y is up.
constexpr long double min_sine_to_up = 1e-12L;

class LongCamera {
 public:
  LongCamera(const view::Camera& camera, std::uint32_t width, std::uint32_t height)
      : eye_(camera.eye),
        perspective_(camera.projection == view::Projection::perspective),
        middle_x_((static_cast<long double>(width) - 1) / 2),
        middle_y_((static_cast<long double>(height) - 1) / 2) {
    const LongVector view = LongVector(camera.centre) - eye_;
    forward_ = glm::normalize(view);
    const LongVector across = glm::cross(forward_, LongVector(camera.up));
    const bool is_along = glm::length(across) <= min_sine_to_up;
    right_ = glm::normalize(is_along ? glm::cross(forward_, LongVector(0, 1, 0)) : across);
    up_ = glm::cross(right_, forward_);
    const long double tangent = std::tan(std::numbers::pi_v<long double> / 16);
    pixel_ = 2 * tangent / height * (perspective_ ? 1 : glm::length(view));
    min_unit_ = perspective_ ? 0 : glm::length(view);
  }

  /// The ray of a pixel centre; t is the distance from the eye along the view axis, in model units.
  [[nodiscard]] Line ray(std::uint32_t column, std::uint32_t row) const {
    const long double x = (column - middle_x_ + nudge_right) * pixel_;
    const long double y = (row - middle_y_ + nudge_down) * pixel_;
    const LongVector aside = x * right_ - y * up_;
    return perspective_ ? Line{eye_, forward_ + aside} : Line{eye_ + aside, forward_};
  }

  [[nodiscard]] bool is_perspective() const { return perspective_; }

  [[nodiscard]] bool same_depth(long double a, long double b) const {
    return std::abs(b - a) <= same_depth_tolerance * std::max({std::abs(a), std::abs(b), min_unit_});
  }

  /// Column and row of a point in the picture, in fractions of pixels, and its distance along the view axis.
  [[nodiscard]] LongVector see(const LongVector& point) const {
    const LongVector d = point - eye_;
    const long double distance = glm::dot(d, forward_);
    const long double unit = perspective_ ? pixel_ * distance : pixel_;
    return {middle_x_ + glm::dot(d, right_) / unit, middle_y_ - glm::dot(d, up_) / unit, distance};
  }

 private:
  LongVector eye_;
  bool perspective_;
  long double middle_x_;
  long double middle_y_;
  LongVector right_{};
  LongVector up_{};
  LongVector forward_{};
  long double pixel_ = 0;  ///< orthographic: model units; perspective: tangent
  /// Lower limit of the unit of the tolerance: |centre - eye| in an orthographic view, which also shows solids at the
  /// eye and behind it; 0 in perspective.
  long double min_unit_ = 0;
};

/// The pixels [x0, x1) x [y0, y1) at which a solid may be seen.
struct Window {
  std::uint32_t x0, y0, x1, y1;
};

Window pixel_window(const TrueSolid& solid, const LongCamera& camera, std::uint32_t width, std::uint32_t height,
                    long double near) {
  long double x0 = width;
  long double y0 = height;
  long double x1 = 0;
  long double y1 = 0;
  for (const LongVector& corner : solid.corners()) {
    const LongVector seen = camera.see(corner);
    // A solid that reaches in front of the near plane may be anywhere in the picture.
    if (camera.is_perspective() && seen.z < near) return {0, 0, width, height};
    x0 = std::min(x0, std::floor(seen.x));
    y0 = std::min(y0, std::floor(seen.y));
    x1 = std::max(x1, std::ceil(seen.x) + 1);
    y1 = std::max(y1, std::ceil(seen.y) + 1);
  }
  const auto clamped = [](long double value, std::uint32_t top) {
    return static_cast<std::uint32_t>(std::clamp(value, 0.0L, static_cast<long double>(top)));
  };
  return {clamped(x0, width), clamped(y0, height), clamped(x1, width), clamped(y1, height)};
}

constexpr long double infinitely_far = std::numeric_limits<long double>::infinity();

struct RayEvent {
  long double depth;
  std::uint32_t primitive;
  bool enters;
};

/// Computes the pixels of one picture.
class RayPainter {
 public:
  /// `nearest`: the distance at which each pixel's ray first meets a solid, regardless of the near plane. paint()
  /// updates it.
  RayPainter(const model::Tree& tree, std::span<const TrueSolid> solids, const view::Camera& camera, long double near,
             Truth& truth, std::span<long double> nearest)
      : solids_(solids),
        view_(camera, truth.width, truth.height),
        near_(near),
        truth_(truth),
        nearest_(nearest),
        on_ray_(tree) {
    for (const TrueSolid& solid : solids)
      windows_.push_back(pixel_window(solid, view_, truth.width, truth.height, near));
  }

  /// Computes the pixels whose rays meet something nearer than `before`.
  void paint(long double before) {
    for (std::uint32_t row = 0; row < truth_.height; ++row) {
      enter_row(row);
      for (std::uint32_t column = 0; column < truth_.width; ++column) {
        const std::size_t pixel = static_cast<std::size_t>(row) * truth_.width + column;
        if (nearest_[pixel] < before) paint_pixel(column, row, pixel);
      }
    }
  }

 private:
  void enter_row(std::uint32_t row) {
    in_row_.clear();
    for (std::uint32_t i = 0; i < windows_.size(); ++i) {
      if (windows_[i].y0 <= row && row < windows_[i].y1) in_row_.push_back(i);
    }
  }

  void paint_pixel(std::uint32_t column, std::uint32_t row, std::size_t pixel) {
    const Line ray = view_.ray(column, row);
    long double nearest = infinitely_far;
    events_.clear();
    for (const std::uint32_t i : in_row_) {
      if (column < windows_[i].x0 || column >= windows_[i].x1) continue;
      Interval in = solids_[i].on(ray);
      if (in.empty()) continue;
      nearest = std::min(nearest, in.low);
      if (view_.is_perspective()) in.low = std::max(in.low, near_);
      if (in.empty()) continue;
      events_.push_back({in.low, i, true});
      events_.push_back({in.high, i, false});
    }
    nearest_[pixel] = nearest;
    std::sort(events_.begin(), events_.end(), [](const RayEvent& a, const RayEvent& b) { return a.depth < b.depth; });
    const RayEvent* seen =
        first_seen(on_ray_, std::span<const RayEvent>(events_),
                   [&](const RayEvent& a, const RayEvent& b) { return view_.same_depth(a.depth, b.depth); });
    truth_.distance[pixel] =
        seen == nullptr ? std::numeric_limits<double>::infinity() : static_cast<double>(seen->depth);
    truth_.owner[pixel] = seen == nullptr ? nothing : seen->primitive;
  }

  std::span<const TrueSolid> solids_;
  const LongCamera view_;
  const long double near_;
  Truth& truth_;
  std::span<long double> nearest_;
  TreeOnRay on_ray_;
  std::vector<Window> windows_;
  std::vector<std::uint32_t> in_row_;
  std::vector<RayEvent> events_;
};

}  // namespace

AnalyticPictures::AnalyticPictures(const model::Tree& tree, const facet::Faceting& drawn_as, const view::Camera& camera,
                                   std::uint32_t width, std::uint32_t height)
    : tree_(tree), camera_(camera), truth_(empty_truth(width, height)), nearest_(truth_.owner.size(), -infinitely_far) {
  truth_.plane.clear();
  for (const model::Primitive& primitive : tree.primitives) meant_.push_back(intended_solid(primitive, drawn_as));
  for (const model::Primitive& primitive : meant_) solids_.emplace_back(primitive);
}

const Truth& AnalyticPictures::truth(const isa::DepthScale& depth) {
  if (tree_.root == model::no_index) return truth_;
  const long double near = depth.near;
  const bool has_changed = near_ && *near_ != near && camera_.projection == view::Projection::perspective;
  if (!near_ || has_changed) {
    RayPainter painter(tree_, solids_, camera_, near, truth_, nearest_);
    long double before = infinitely_far;
    if (near_) before = std::max(*near_, near);
    painter.paint(before);
  }
  near_ = near;
  return truth_;
}

Truth analytic_truth(const model::Tree& tree, const facet::Faceting& drawn_as, const view::Camera& camera,
                     std::uint32_t width, std::uint32_t height, const isa::DepthScale& depth) {
  return AnalyticPictures(tree, drawn_as, camera, width, height).truth(depth);
}

}  // namespace csgsim::judges
