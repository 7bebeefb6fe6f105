#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/view/camera.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

using view::Projection;

/// How a hard case of curved surfaces is drawn.
struct CurvedLook {
  std::uint32_t width = 41;  ///< odd: the middle of the picture is a pixel centre
  std::uint32_t height = 33;
  unsigned z_bits = 20;
  unsigned fraction_bits = 12;
  std::optional<double> near{};
  /// How many pictures, or calls of those that draw several, share all that must not change one: each is drawn by one
  /// such part of the ways.
  std::uint32_t shares = 1;
  std::uint32_t share = 0;
  bool engines = false;  ///< hold all engines against each other too
  /// Whether the host may give up quadrics of the case for facets, as `--curves auto` does.
  bool may_be_faceted = false;
};

/// Curves are drawn by facets where the host gives up their quadrics.
inline const CurvedLook lenient{.may_be_faceted = true};

/// Sums over pictures.
struct CurvedVerdict {
  std::uint64_t pictures = 0;
  std::uint64_t covered = 0;        ///< pixels, in truth
  std::uint64_t wrong = 0;          ///< pixels
  std::uint64_t unexplained = 0;    ///< of these, by the stated bounds
  std::uint64_t against_rules = 0;  ///< pixels that are not what the rules make of the view's integers (tests/oracle)
  std::uint64_t quadrics = 0;       ///< that are drawn
  std::uint64_t edges = 0;          ///< of these, as edge tests
  std::uint64_t inside = 0;         ///< of these, around the eye

  CurvedVerdict& operator+=(const CurvedVerdict& other);
};

/// A picture against the exact oracle (sim/judges) and against the rules.
CurvedVerdict judged(const Compiled& compiled, const observe::Frame& frame);

/// Draws a model without facets on a machine of degree 2; fails the test
///
/// - for a wrong pixel that no stated bound explains, and for one that is not what the rules make of the integers,
/// - where another kind of machine, strategy, colouring or pruning draws another depth, label or colour,
/// - where an expression overflows.
CurvedVerdict look_curved(const std::string& csg, const view::Camera& camera, const CurvedLook& how = {});

/// From that eye at the point, in both projections.
CurvedVerdict look_both_ways(const std::string& csg, const glm::dvec3& eye, const glm::dvec3& centre,
                             const CurvedLook& how = {});

/// What fills the picture from an oblique direction and along an axis, in both projections: 4 pictures.
CurvedVerdict look_at_all(const std::string& csg, const CurvedLook& how = {});

/// The setup of that look.
Setup curved_setup(const view::Camera& camera, const CurvedLook& how = {});

/// The functional engine's picture, without facets.
observe::Frame curved_picture(const std::string& csg, const view::Camera& camera, const CurvedLook& how = {});

}  // namespace csgsim::testing
