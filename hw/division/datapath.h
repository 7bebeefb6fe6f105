// Interface of the divider to the memories of the model, which counts and times its operations.
// Used by hw/pixel_square.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "hw/division/corners.h"
#include "hw/division/counts.h"
#include "hw/division/display_model.h"
#include "hw/isa/instruction.h"

namespace csgsim::division {

/// Datapath of the divider: memories that hold the model, from which each record is read when needed, and units that
/// test and write. All operations of the divider pass through here sequentially and are counted. Derived classes
/// account for the clocks of a machine.
class Datapath {
 public:
  explicit Datapath(const ModelHeader& header) : header_(header) {}
  Datapath(const Datapath&) = delete;
  Datapath& operator=(const Datapath&) = delete;
  virtual ~Datapath() = default;

  /// Header of the model, held in registers.
  [[nodiscard]] const ModelHeader& header() const { return header_; }

  /// Reads a primitive for comparing its box.
  PrimitiveHead visit_primitive(std::uint32_t primitive);

  /// Reads the given half-spaces of a primitive and tests them at the corners of the pixels; `numbers` are indices
  /// within the primitive.
  std::vector<TestedHalfspace> test(std::uint32_t primitive, std::span<const std::uint32_t> numbers,
                                    const Rectangle& pixels);

  /// Reads `halfspaces` half-spaces of a side and compares them with the leaders of a cell.
  void compare_with_leaders(std::uint64_t halfspaces);

  /// Visits a node of the tree.
  void visit_node();

  /// Writes an instruction of the square.
  void write(const isa::Instruction& instruction);

  /// Returns the counts of all operations since the last call, and resets them.
  Counts take_counts() { return std::exchange(counts_, {}); }

 protected:
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  virtual PrimitiveHead read_primitive(std::uint32_t primitive) = 0;
  virtual Halfspace read_halfspace(std::uint32_t primitive, std::uint32_t number) = 0;
  virtual Plane read_plane(std::uint32_t index) = 0;
  // Hooks that account for the clocks of counted operations.
  virtual void on_box() {}
  virtual void on_corner_test(bool /*is_last*/) {}
  virtual void on_cell(std::uint64_t /*halfspaces*/) {}
  virtual void on_node() {}
  virtual void on_instruction(const isa::Instruction& /*instruction*/) {}

  ModelHeader header_;
  Counts counts_;
};

/// Reads directly from a model without accounting for clocks. The model must outlive this object.
class PlainDatapath final : public Datapath {
 public:
  explicit PlainDatapath(const DisplayModel& model) : Datapath(model), model_(model) {}

 private:
  PrimitiveHead read_primitive(std::uint32_t primitive) override { return model_.primitives[primitive]; }
  Halfspace read_halfspace(std::uint32_t primitive, std::uint32_t number) override {
    return model_.primitives[primitive].halfspaces[number];
  }
  Plane read_plane(std::uint32_t index) override { return model_.planes[index]; }

  const DisplayModel& model_;
};

}  // namespace csgsim::division
