// Quadrics along the rays of a picture, with exact decisions.
// Used by the sight and the quadric bounds.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "host/facet/quadric_table.h"
#include "sim/judges/exact_camera.h"
#include "sim/judges/surd.h"

namespace csgsim::judges {

/// Selects a depth of a surface on a ray: planes have one, quadrics two.
enum class Root : std::int8_t { nearer = -1, only = 0, farther = 1 };

/// One surface of a ray: a canonical plane, or one root of a canonical quadric.
struct Sheet {
  std::uint32_t index = 0;
  Root root = Root::only;

  bool operator==(const Sheet&) const = default;
};

/// A part of a ray: [front, back), unlimited at a missing end.
struct Part {
  std::optional<Sheet> front;
  std::optional<Sheet> back;
};

/// Up to two parts of a ray, nearest first.
struct Parts {
  std::array<Part, 2> all;
  std::size_t count = 0;

  [[nodiscard]] const Part* begin() const { return all.data(); }
  [[nodiscard]] const Part* end() const { return all.data() + count; }
};

/// A number with an error bound.
struct Estimate {
  double value = 0;
  double error = 0;
};

/// Approximately c + x x + y y + xx x^2 + xy x y + yy y^2, with an error of at most `error` at any place of the
/// picture.
struct FilterQuadratic {
  double c = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  double yy = 0;
  double error = 0;

  [[nodiscard]] double at(Place place) const {
    return c + place.x * (x + xx * place.x + xy * place.y) + place.y * (y + yy * place.y);
  }
};

/// A quadric along the rays of the picture, a q^2 + 2 L q + Q <= 0, approximately.
struct SightQuadric {
  int opening = 0;         ///< sign of a: 1 if a ray is inside between its depths, -1 if outside between them
  bool is_edge = false;    ///< a = 0 and L = 0 everywhere: whole rays are inside or outside
  int ahead = 0;           ///< for a cone: -1 if rays end in the nappe in the axis's direction, 1 if they begin there
  double condition = 1;    ///< amplification of the rounding of doubles in a
  FilterQuadratic middle;  ///< -L / a, linear: the depths are middle -+ sqrt(square). Unused if a = 0
  FilterQuadratic square;  ///< (L^2 - a Q) / a^2; for an edge -Q
  FilterQuadratic nappe;   ///< for a cone, linear: negative where a ray is in the nappe that the axis points into
  double a = 0;
  FilterQuadratic slope;    ///< L, linear
  FilterQuadratic value;    ///< Q
  double square_terms = 0;  ///< bound over the picture of the sum of the magnitudes of all terms of L^2 / a^2 and Q / a
};

/// The canonical quadrics of a model as a camera sees them: the doubles of `to_unit` and `origin` are taken as exact;
/// depth is that of Sight (sight.h).
///
/// Not thread-safe: exact numbers are computed on first use and cached.
class QuadricSight {
 public:
  QuadricSight(const facet::QuadricTable& quadrics, const ExactCamera& camera);

  [[nodiscard]] const SightQuadric& quadric(std::uint32_t index) const { return quadrics_[index]; }
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(quadrics_.size()); }

  /// The parts of a ray inside the quadric (for a cone, inside that nappe), exact:
  ///
  /// - a > 0: between its depths; nothing if they are equal, on the outline.
  /// - a < 0: before the nearer depth and from the farther one, for a cone only at the depth that is on the nappe;
  /// everything if there are no depths.
  /// - a = 0: to or from the only depth, which both roots denote. If also L = 0, everything or nothing by the sign of
  /// Q; Q = 0 is inside if the quadric is an edge, seen along its axis or from its apex, and otherwise outside.
  ///
  /// Parts behind the eye are included.
  [[nodiscard]] Parts parts(const facet::QuadricSide& side, Place place) const;

  /// Approximate depth of the sheet at the place; the ray must meet its quadric.
  [[nodiscard]] Estimate estimate_depth(Sheet sheet, Place place) const;

  /// Exact depth of the sheet at the place; the ray must meet its quadric.
  [[nodiscard]] Surd exact_depth(Sheet sheet, Place place) const;

 private:
  /// c + x x + y y + xx x^2 + xy x y + yy y^2.
  struct ExactQuadratic {
    Dyadic c, x, y, xx, xy, yy;

    [[nodiscard]] Dyadic at(Place place) const;
  };

  struct Exact {
    Dyadic a;
    ExactLinear l;
    ExactQuadratic q;
    ExactQuadratic discriminant;
    ExactLinear nappe;
    int ahead = 0;
    double sizes_of_a = 0;
  };

  [[nodiscard]] Exact make_exact(std::uint32_t index) const;
  [[nodiscard]] const Exact& exact(std::uint32_t index) const;
  [[nodiscard]] SightQuadric make_filter(std::uint32_t index) const;
  [[nodiscard]] FilterQuadratic filter(const ExactQuadratic& exact, double divisor) const;
  [[nodiscard]] double size_over_picture(const FilterQuadratic& quadratic) const;
  [[nodiscard]] int discriminant_sign(std::uint32_t index, Place place) const;
  [[nodiscard]] bool is_on_nappe(const facet::QuadricSide& side, Place place) const;
  [[nodiscard]] Parts tangent_parts(const facet::QuadricSide& side, Place place) const;

  const facet::QuadricTable& table_;
  const ExactCamera& camera_;
  Vector eye_;  ///< relative to QuadricTable::centre()
  std::vector<SightQuadric> quadrics_;
  mutable std::unordered_map<std::uint32_t, Exact> kept_;
};

}  // namespace csgsim::judges
