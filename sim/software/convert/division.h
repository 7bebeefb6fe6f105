// Division of faces by other bodies.
// Used by fragments.cpp, exact_faces.cpp and side_by_side.cpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "hw/base/work.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/convert/fragments.h"
#include "sim/software/convert/local_tree.h"
#include "sim/software/planes/sheet.h"

namespace csgsim::software::convert {

/// Name of the operation in work limits.
inline constexpr std::string_view converting = "converting the model to a boundary";

/// Another body that may cut the face to be divided.
struct Operand {
  std::uint32_t body = 0;
  bool is_coplanar = false;  ///< whether it has a face in the plane, in this region
  bool is_behind = false;    ///< for a coplanar body: whether it is behind the plane
  bool owns = false;         ///< whether the shared part of the plane belongs to it and is omitted here
  Numbers tests{};  ///< its faces whose planes may intersect the region; the region is entirely inside the others
  Known known{};
};

/// Removes the operands that are not kept. The tree must not refer to them.
void keep_operands(const std::vector<bool>& is_kept, LocalTree& tree, std::vector<Operand>& operands);

/// Divides a face of a body by other bodies into parts that are on the boundary and parts that are not.
class Division {
 public:
  /// Keeps references.
  Division(const Bodies& bodies, Sheet& sheet, std::vector<Fragment>& found, const Work& work)
      : bodies_(bodies), sheet_(sheet), found_(found), work_(work) {}

  /// Divides the face; `region` is the whole face of `body`.
  void operator()(std::uint32_t body, const BodyFace& face, const Region& region, const LocalTree& tree,
                  std::vector<Operand> operands);

 private:
  /// The side of the boundary that a region is on: none; `front`, the solid is behind the plane; `back`, the solid is
  /// in front of it; or `mixed`, different ones in parts of the region.
  enum class Fate : std::uint8_t { none, front, back, mixed };
  struct Part {
    Region region;
    Fate fate;
  };

  Fate divide(const Region& region, const LocalTree& tree, std::vector<Operand> operands);
  [[nodiscard]] Known value_in(const Operand& operand) const;
  [[nodiscard]] Known look(const Region& region, const Bounds& bounds, Operand& operand) const;
  Fate keep_operands(const Region& region, Fate fate);
  bool halve(const Region& region, const Bounds& bounds, const LocalTree& tree, const std::vector<Operand>& operands,
             Fate& fate);
  Fate split(const Region& region, const LocalTree& tree, const std::vector<Operand>& operands, std::size_t by,
             const Region& section);
  [[nodiscard]] Region section(const Region& region, const Operand& operand);

  const Bodies& bodies_;
  Sheet& sheet_;
  std::vector<Fragment>& found_;
  const Work& work_;
  std::vector<Part> parts_;  ///< boundary parts of the current face
};

}  // namespace csgsim::software::convert
