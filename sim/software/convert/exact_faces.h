// Exact computation of the faces of bodies.
// Used by bodies.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/facet/solid.h"
#include "hw/base/work.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/planes/sheet.h"

namespace csgsim::software::convert {

/// Computes the faces of bodies exactly: the part of each face's plane inside all other half-spaces of the body.
class ExactFaces {
 public:
  /// Keeps references. Vertices of solids are relative to `reference`, in model units, and represent corners within the
  /// tolerance.
  ExactFaces(const WholePlanes& planes, const glm::dvec3& reference, double tolerance, const Work& work)
      : planes_(planes), reference_(reference), tolerance_(tolerance), work_(work), sheet_(planes) {}

  /// Sets the sides, boxes and balls of `body`; the half-spaces of its faces must already be set. `face_of` maps faces
  /// of the solid to faces of the body. A body without volume gets no sides and an empty box.
  void complete(const facet::Solid& solid, std::span<const std::uint32_t> face_of, Body& body);

 private:
  /// Data of a body's face that is derived from faces of the solid.
  struct Outline {
    std::vector<std::uint32_t> corners;     ///< vertices of the solid
    std::vector<std::uint32_t> neighbours;  ///< faces of the body that share a corner with this one, ascending
  };

  [[nodiscard]] static std::vector<Outline> outlines_of(const facet::Solid& solid,
                                                        std::span<const std::uint32_t> face_of, std::size_t faces);
  void cut(std::span<const Outline> outlines, Body& body);
  void cut_by_all(std::span<const Outline> outlines, Body& body);
  void store(const Region& region, const Outline& outline, BodyFace& face, Body& body) const;
  [[nodiscard]] std::uint32_t vertex_at(std::uint32_t corner, const Outline& outline, const Body& body) const;
  [[nodiscard]] bool is_closed(const Body& body) const;
  [[nodiscard]] bool ends_at(const Body& body, const BodyFace& face, std::uint32_t along, const Meeting& start,
                             const Meeting& end) const;
  void find_balls(Body& body) const;

  const WholePlanes& planes_;
  glm::dvec3 reference_;
  double tolerance_;
  const Work& work_;
  Sheet sheet_;
};

}  // namespace csgsim::software::convert
