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

/// What the divider works with: memories that hold the model, from which a record is read whenever it is needed, and
/// what tests and writes. All that it does goes by here, one thing after another, and is counted. A machine spends its
/// clocks there.
class Datapath {
 public:
  explicit Datapath(const ModelHeader& header) : header_(header) {}
  Datapath(const Datapath&) = delete;
  Datapath& operator=(const Datapath&) = delete;
  virtual ~Datapath() = default;

  /// In registers.
  [[nodiscard]] const ModelHeader& header() const { return header_; }

  /// Reads a primitive, to hold its box against another.
  PrimitiveHead look_at(std::uint32_t primitive);

  /// Reads those half-spaces of a primitive and tests them at the corners of the pixels; `numbers` count from its
  /// first.
  std::vector<Tested> test(std::uint32_t primitive, std::span<const std::uint32_t> numbers, const Rectangle& pixels);

  /// Reads so many half-spaces of a side, to hold them against the leaders of a cell.
  void hold_against_leaders(std::uint64_t halfspaces);

  /// Looks at a node of the tree.
  void look_at_node();

  /// Writes an instruction of the square.
  void write(const isa::Instruction& instruction);

  /// All that it has done since that was asked for last.
  Counts take_counts() { return std::exchange(counts_, {}); }

 protected:
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  virtual PrimitiveHead read_primitive(std::uint32_t primitive) = 0;
  virtual Halfspace read_halfspace(std::uint32_t primitive, std::uint32_t number) = 0;
  virtual Plane read_plane(std::uint32_t index) = 0;
  // Spend the clocks of what has been counted.
  virtual void on_box() {}
  virtual void on_corner_test(bool /*is_last*/) {}
  virtual void on_cell(std::uint64_t /*halfspaces*/) {}
  virtual void on_node() {}
  virtual void on_instruction(const isa::Instruction& /*instruction*/) {}

  ModelHeader header_;
  Counts counts_;
};

/// Reads from a model itself, in no time. The model has to live as long.
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
