#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/view/camera.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

using view::Projection;

/// The parameters with which a hard case of curved surfaces is drawn.
struct CurvedLook {
  std::uint32_t width = 41;  ///< odd: the middle of the picture is a pixel centre
  std::uint32_t height = 33;
  unsigned z_bits = 20;
  unsigned fraction_bits = 12;
  std::optional<double> near{};
  /// Number of pictures that share the variants (machines and options that must not change a picture): each picture is
  /// compared with one part of them.
  std::uint32_t shares = 1;
  std::uint32_t share = 0;
  bool engines = false;  ///< also compare all engines with each other
  /// Whether the host may replace quadrics of the case by facets, as `--curves auto` does.
  bool may_be_faceted = false;
};

/// Allows the host to replace quadrics by facets.
inline const CurvedLook lenient{.may_be_faceted = true};

/// Sums over pictures.
struct CurvedVerdict {
  std::uint64_t pictures = 0;
  std::uint64_t covered = 0;        ///< pixels that the exact oracle covers
  std::uint64_t wrong = 0;          ///< wrong pixels
  std::uint64_t unexplained = 0;    ///< wrong pixels that the stated bounds do not explain
  std::uint64_t against_rules = 0;  ///< pixels that differ from the rules for the view's integers (tests/oracle)
  std::uint64_t quadrics = 0;       ///< quadrics drawn
  std::uint64_t edges = 0;          ///< quadrics drawn as edge tests
  std::uint64_t inside = 0;         ///< quadrics around the eye

  CurvedVerdict& operator+=(const CurvedVerdict& other);
};

/// Compares a picture with the exact oracle (sim/judges) and with the rules.
CurvedVerdict judge_picture(const Compiled& compiled, const observe::Frame& frame);

/// Draws a model without facets on a machine of degree 2. Fails the test
///
/// - for a wrong pixel that no stated bound explains, and for one that differs from the rules for the integers,
/// - where another kind of machine, strategy, colouring or pruning draws another depth, label or colour,
/// - where an expression overflows.
CurvedVerdict look_curved(const std::string& csg, const view::Camera& camera, const CurvedLook& how = {});

/// Draws the model from the eye towards the centre, in both projections.
CurvedVerdict look_both_ways(const std::string& csg, const glm::dvec3& eye, const glm::dvec3& centre,
                             const CurvedLook& how = {});

/// Draws the whole model from an oblique direction and along an axis, in both projections: 4 pictures.
CurvedVerdict look_at_all(const std::string& csg, const CurvedLook& how = {});

/// The setup of such a drawing.
Setup curved_setup(const view::Camera& camera, const CurvedLook& how = {});

/// The functional engine's picture, without facets.
observe::Frame curved_picture(const std::string& csg, const view::Camera& camera, const CurvedLook& how = {});

}  // namespace csgsim::testing
