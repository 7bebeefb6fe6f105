#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::observe {

inline constexpr std::uint32_t no_owner = 0xffffffffU;

/// A finished picture, in row order. Of see-through surfaces that are blended into it, as of others, the nearest
/// counts.
struct Frame {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint32_t> colour;  ///< as the colour field holds it (hw/isa/colour_format.h)
  std::vector<std::uint32_t> depth;   ///< depth steps of the nearest surface seen; all ones where nothing is seen
  std::vector<std::uint32_t> owner;   ///< index of the primitive whose surface that is, or no_owner
  /// The same of the opaque surface that is seen, through others or not; empty where the Program blends none.
  std::vector<std::uint32_t> opaque_depth{};
  std::vector<std::uint32_t> opaque_owner{};

  bool operator==(const Frame&) const = default;
};

/// With the opaque surfaces in place of the nearest.
Frame of_opaque(Frame frame);

/// Assembles the picture of a run, segment by segment, on the background. Pixel memory has no room for owners: they are
/// taken down from outside, as each primitive's depth is copied into the depth field; where several are drawn as one
/// solid, as the colour of each is written. In the same way owners and depths of see-through surfaces are taken down
/// that the Program blends: from an effect's fields EFFECT.nearest_depth and EFFECT.nearest_colour, until the effect
/// first compares that depth with the depth field. By the end of the frame they may hold another layer.
class FrameObserver : public engine::Observer {
 public:
  explicit FrameObserver(const isa::Program& program);

  [[nodiscard]] bool reads_after(const isa::Instruction& instruction) const override;
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override;
  [[nodiscard]] bool reads_enable_alone(const isa::Instruction& instruction) const override;
  void enabled_after(const isa::Instruction& instruction, const isa::Region& part,
                     std::span<const std::uint64_t> words) override;
  void after_segment(std::uint32_t segment, const engine::PixelState& state) override;

  [[nodiscard]] const Frame& frame() const& { return frame_; }
  [[nodiscard]] Frame frame() && { return std::move(frame_); }

  /// Whether the instruction makes an enabled pixel its primitive's, if nothing comes after it.
  [[nodiscard]] bool merges(const isa::Instruction& instruction) const {
    return is_merge(instruction) || is_pane_merge(instruction);
  }
  /// Whose see-through surface is before the opaque one so far; no_owner where there is none.
  [[nodiscard]] std::uint32_t pane_owner(std::size_t pixel) const {
    return panes_.owner.empty() ? no_owner : panes_.owner[pixel];
  }

  /// See-through surfaces before the opaque ones, of segments that have not ended. Empty where the Program has none.
  struct Panes {
    std::vector<std::uint32_t> owner;  ///< no_owner where there is none
    std::vector<std::uint32_t> depth;  ///< unread_depth where it has not been taken down yet, or there is none

    bool operator==(const Panes&) const = default;
  };
  /// No depth of a surface.
  static constexpr std::uint32_t unread_depth = 0xffffffffU;

  /// All that has been gathered at an instruction boundary.
  struct Gathered {
    Frame frame;
    std::vector<std::uint32_t> candidate_owner;  ///< of every pixel, or none
    Panes panes{};                               ///< of every pixel, or none

    bool operator==(const Gathered&) const = default;
  };
  [[nodiscard]] Gathered gathered() const { return {frame_, candidate_owner_, panes_}; }
  /// Goes on from what an observer of the same Program gathered.
  void restore(Gathered gathered);

 private:
  void find_panes(const isa::Program& program);
  [[nodiscard]] bool is_merge(const isa::Instruction& instruction) const;
  [[nodiscard]] bool writes_panes(const isa::Instruction& instruction) const;
  [[nodiscard]] bool is_pane_merge(const isa::Instruction& instruction) const;
  [[nodiscard]] bool begins_panes(const isa::Instruction& instruction) const;
  [[nodiscard]] bool colours_pane(const isa::Instruction& instruction) const;
  [[nodiscard]] bool compares_panes(const isa::Instruction& instruction) const;
  [[nodiscard]] bool colours_one_of_several(const isa::Instruction& instruction, isa::Field colour) const;
  /// Calls take(pixel of the picture) for each that is enabled.
  template <class Take>
  void for_enabled(const isa::Region& part, std::span<const std::uint64_t> words, const Take& take) const;
  /// A picture may be drawn several times, one over the other: what was seen before is not any more.
  void forget_unseen(const isa::Region& region);
  void take_pane_depths(const engine::PixelState& state);
  /// What stands before opaque surfaces becomes the picture's.
  void put_panes(const isa::Region& region);
  void place(const engine::PixelState& state, isa::Field field, std::vector<std::uint32_t>& picture);

  isa::Field depth_;
  isa::Field colour_;
  isa::Field candidate_colour_;
  isa::Field nearest_;                         ///< depth; of width 0 where the Program blends no see-through surfaces
  isa::Field nearest_colour_;                  ///< of the same
  std::uint8_t pane_effect_ = isa::no_effect;  ///< that blends them
  Frame frame_;
  std::vector<std::uint32_t> candidate_owner_;  ///< whose colour is beside Z1, where several are drawn as one
  Panes panes_;
  std::vector<bool> drawn_;  ///< segments that have instructions
  std::vector<std::uint32_t> values_;
  std::vector<std::uint64_t> enable_;
};

}  // namespace csgsim::observe
