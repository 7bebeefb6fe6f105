#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/facet/solid.h"
#include "hw/base/work.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/planes/sheet.h"

namespace csgsim::software::convert {

/// Finds the faces of bodies exactly: of each face's plane, what all other half-spaces of the body leave.
class ExactFaces {
 public:
  /// Keeps references. Vertices of solids are relative to `reference`, in model units, and stand for corners that are
  /// within the tolerance.
  ExactFaces(const WholePlanes& planes, const glm::dvec3& reference, double tolerance, const Work& work)
      : planes_(planes), reference_(reference), tolerance_(tolerance), work_(work), sheet_(planes) {}

  /// Sets the sides, the boxes and the balls of a body whose faces have their half-spaces; `face_of` has the number of
  /// the body's face for each face of the solid. A body without volume gets no sides and an empty box.
  void find(const facet::Solid& solid, std::span<const std::uint32_t> face_of, Body& body);

 private:
  /// What is known of a face of the body from those of the solid.
  struct Outline {
    std::vector<std::uint32_t> corners;     ///< vertices of the solid
    std::vector<std::uint32_t> neighbours;  ///< faces of the body that share a corner with it, ascending
  };

  [[nodiscard]] static std::vector<Outline> outlines_of(const facet::Solid& solid,
                                                        std::span<const std::uint32_t> face_of, std::size_t faces);
  void cut(std::span<const Outline> outlines, Body& body);
  void cut_by_all(std::span<const Outline> outlines, Body& body);
  void take(const Region& region, const Outline& outline, BodyFace& face, Body& body) const;
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
