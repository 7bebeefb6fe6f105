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

/// What work is charged for.
inline constexpr std::string_view converting = "converting the model to a boundary";

/// A body besides the one whose face is divided.
struct Operand {
  std::uint32_t body = 0;
  bool is_coplanar = false;  ///< has a face in the plane, on that side
  bool is_behind = false;    ///< if so: the body is behind the plane
  bool owns = false;         ///< what it shares of the plane is its own, and is left out
  Numbers tests{};           ///< its faces whose planes may pass through the region: all of it is behind the others
  Known known{};
};

/// Leaves out the operands that are not kept. The tree must not refer to them.
void keep(const std::vector<bool>& is_kept, LocalTree& tree, std::vector<Operand>& operands);

/// Divides a face of a body by others into parts of the boundary and parts that are none.
class Division {
 public:
  /// Keeps references.
  Division(const Bodies& bodies, Sheet& sheet, std::vector<Fragment>& found, const Work& work)
      : bodies_(bodies), sheet_(sheet), found_(found), work_(work) {}

  /// The region is all of the face, which is one of the body's.
  void operator()(std::uint32_t body, const BodyFace& face, const Region& region, const LocalTree& tree,
                  std::vector<Operand> operands);

 private:
  /// What has become of a region.
  enum class Fate : std::uint8_t { none, front, back, mixed };
  struct Part {
    Region region;
    Fate fate;
  };

  Fate divide(const Region& region, const LocalTree& tree, std::vector<Operand> operands);
  [[nodiscard]] Known value_in(const Operand& operand) const;
  [[nodiscard]] Known look(const Region& region, const Bounds& bounds, Operand& operand) const;
  Fate keep(const Region& region, Fate fate);
  bool halve(const Region& region, const Bounds& bounds, const LocalTree& tree, const std::vector<Operand>& operands,
             Fate& fate);
  Fate split(const Region& region, const LocalTree& tree, const std::vector<Operand>& operands, std::size_t by,
             const Region& section);
  [[nodiscard]] Region section(const Region& region, const Operand& operand);

  const Bodies& bodies_;
  Sheet& sheet_;
  std::vector<Fragment>& found_;
  const Work& work_;
  std::vector<Part> parts_;  ///< that are kept of the present face
};

}  // namespace csgsim::software::convert
