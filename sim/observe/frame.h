#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::sim {

inline constexpr std::uint32_t no_owner = 0xffffffffU;

/// A finished picture as pixel memory holds it, in row order.
struct Frame {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint32_t> colour;  ///< as the colour field holds it (hw/isa/colour_format.h)
  std::vector<std::uint32_t> depth;   ///< depth steps; all ones where nothing is seen
  std::vector<std::uint32_t> owner;   ///< index of the primitive seen, or no_owner

  bool operator==(const Frame&) const = default;
};

/// Assembles the picture of a run, segment by segment, on the background. Pixel memory has no room for owners: they are
/// taken down from outside, as each primitive's depth is copied into the depth field; where several are drawn as one
/// solid, as the colour of each is written.
class FrameObserver : public Observer {
 public:
  explicit FrameObserver(const isa::Program& program);

  [[nodiscard]] bool reads_after(const isa::Instruction& instruction) const override;
  void after_instruction(const Step& step, const PixelState& state) override;
  [[nodiscard]] bool reads_enable_alone(const isa::Instruction& instruction) const override {
    return reads_after(instruction);
  }
  void enabled_after(const isa::Instruction& instruction, const isa::Region& part,
                     std::span<const std::uint64_t> words) override;
  void after_segment(std::uint32_t segment, const PixelState& state) override;

  [[nodiscard]] const Frame& frame() const& { return frame_; }
  [[nodiscard]] Frame frame() && { return std::move(frame_); }

  /// All that has been gathered at an instruction boundary.
  struct Gathered {
    Frame frame;
    std::vector<std::uint32_t> candidate_owner;  ///< of every pixel, or none

    bool operator==(const Gathered&) const = default;
  };
  [[nodiscard]] Gathered gathered() const { return {frame_, candidate_owner_}; }
  /// Goes on from what an observer of the same Program gathered.
  void restore(Gathered gathered);

 private:
  [[nodiscard]] bool is_merge(const isa::Instruction& instruction) const;
  [[nodiscard]] bool colours_one_of_several(const isa::Instruction& instruction, isa::Field colour) const;
  /// A picture may be drawn several times, one over the other: what was seen before is not any more.
  void forget_unseen(const isa::Region& region);
  void place(const PixelState& state, isa::Field field, std::vector<std::uint32_t>& picture);

  isa::Field depth_;
  isa::Field colour_;
  isa::Field candidate_colour_;
  Frame frame_;
  std::vector<std::uint32_t> candidate_owner_;  ///< whose colour is beside Z1, where several are drawn as one
  std::vector<bool> drawn_;                     ///< segments that have instructions
  std::vector<std::uint32_t> values_;
  std::vector<std::uint64_t> enable_;
};

}  // namespace csgsim::sim
