#pragma once

#include <cstdint>
#include <functional>

#include "hw/division/datapath.h"
#include "hw/division/model_memory.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

/// Counts the clocks of a divider in the machine (docs/machines/pixel-square.md), which reads records through a port of
/// `divider.port` bits, tests them, and writes instructions.
class SteppedDatapath final : public division::Datapath {
 public:
  /// The unit that is divided, and the input of the division.
  enum class Level : std::uint8_t {
    group,   ///< first of two levels: a group of squares, from the whole model
    listed,  ///< a square, from the list that the first level produced
    whole,   ///< a square, from the whole model
  };

  struct Callbacks {
    std::function<void(std::uint64_t)> spend;                    ///< adds the given number of clocks
    std::function<void(const isa::Instruction&)> store_command;  ///< writes an instruction to the store, word by word
  };

  /// `remote_planes`: whether the planes did not fit the divider's memory and are read from the host over the link.
  SteppedDatapath(const division::ModelHeader& header, const division::ModelMemory& memory,
                  const machines::Machine& machine, bool remote_planes, Callbacks callbacks);

  /// Sets the level of all following operations.
  void set_level(Level level) { level_ = level; }

 private:
  division::PrimitiveHead read_primitive(std::uint32_t primitive) override;
  division::Halfspace read_halfspace(std::uint32_t primitive, std::uint32_t number) override;
  division::Plane read_plane(std::uint32_t index) override;
  void on_box() override;
  void on_corner_test(bool is_last) override;
  void on_cell(std::uint64_t halfspaces) override;
  void on_node() override;
  void on_instruction(const isa::Instruction& instruction) override;
  [[nodiscard]] std::uint64_t plane_clocks() const;

  const division::ModelMemory& memory_;
  const machines::Machine& machine_;
  const Figures& figures_;
  const bool remote_planes_;
  const Callbacks callbacks_;
  Level level_ = Level::whole;
  std::uint64_t read_ = 0;  ///< clocks to read the records of the current test
  bool testing_ = false;    ///< whether a test overlaps with the current read
};

}  // namespace csgsim::pixel_square
