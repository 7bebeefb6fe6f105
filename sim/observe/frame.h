// Observer that assembles the picture of a run.
// Used throughout sim.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::observe {

inline constexpr std::uint32_t no_owner = 0xffffffffU;

/// A finished picture, in row order. Transparent surfaces that are blended into it count like others: the nearest one
/// is recorded.
struct Frame {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint32_t> colour;  ///< value of the colour field (hw/isa/colour_format.h)
  std::vector<std::uint32_t> depth;   ///< depth steps of the nearest visible surface; all ones if nothing is visible
  std::vector<std::uint32_t> owner;   ///< index of the primitive of that surface, or no_owner
  /// Depth and owner of the visible opaque surface, possibly behind transparent ones; empty if the Program blends none.
  std::vector<std::uint32_t> opaque_depth{};
  std::vector<std::uint32_t> opaque_owner{};

  bool operator==(const Frame&) const = default;
};

/// The frame with depth and owner of the visible opaque surfaces instead of the nearest surfaces.
Frame with_opaque_surfaces(Frame frame);

/// Assembles the picture of a run, segment by segment, over the background. Pixel memory has no room for owners, so
/// they are recorded outside of it: when a primitive's depth is copied into the depth field, or, where several
/// primitives are drawn as one solid, when the colour of each is written. Owners and depths of blended transparent
/// surfaces are recorded in the same way, from an effect's fields EFFECT.nearest_depth and EFFECT.nearest_colour, until
/// the effect first compares that depth with the depth field. At the end of the frame those fields may hold another
/// layer.
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

  /// Whether the instruction makes its primitive the owner of the enabled pixels, unless a later one replaces it.
  [[nodiscard]] bool merges(const isa::Instruction& instruction) const {
    return is_merge(instruction) || is_pane_merge(instruction);
  }
  /// Owner of the nearest transparent surface that is currently in front of the opaque one; no_owner if there is none.
  [[nodiscard]] std::uint32_t pane_owner(std::size_t pixel) const {
    return panes_.owner.empty() ? no_owner : panes_.owner[pixel];
  }

  /// Transparent surfaces in front of the opaque ones, in segments that have not ended. Empty if the Program has none.
  struct Panes {
    std::vector<std::uint32_t> owner;  ///< no_owner if there is none
    std::vector<std::uint32_t> depth;  ///< unread_depth if there is none, or if it has not been read yet

    bool operator==(const Panes&) const = default;
  };
  /// A value that is no depth of a surface.
  static constexpr std::uint32_t unread_depth = 0xffffffffU;

  /// The data collected up to an instruction boundary.
  struct Gathered {
    Frame frame;
    std::vector<std::uint32_t> candidate_owner;  ///< one entry per pixel, or empty
    Panes panes{};                               ///< one entry per pixel, or empty

    bool operator==(const Gathered&) const = default;
  };
  [[nodiscard]] Gathered gathered() const { return {frame_, candidate_owner_, panes_}; }
  /// Continues from the data collected by an observer of the same Program.
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
  /// Calls take(pixel of the picture) for each enabled pixel.
  template <class Take>
  void for_enabled(const isa::Region& part, std::span<const std::uint64_t> words, const Take& take) const;
  /// Clears the owner of pixels that are empty at the end of a segment: an earlier segment with the same pixels may
  /// have set it.
  void forget_unseen(const isa::Region& region);
  void read_pane_depths(const engine::PixelState& state);
  /// Saves the opaque depths and owners, then replaces them in the picture by those of transparent surfaces in front.
  void show_panes_in_front(const isa::Region& region);
  void copy_to_picture(const engine::PixelState& state, isa::Field field, std::vector<std::uint32_t>& picture);

  isa::Field depth_;
  isa::Field colour_;
  isa::Field candidate_colour_;
  isa::Field nearest_;                         ///< depth; of width 0 if the Program blends no transparent surfaces
  isa::Field nearest_colour_;                  ///< colour of that surface
  std::uint8_t pane_effect_ = isa::no_effect;  ///< index of the effect that blends transparent surfaces
  Frame frame_;
  std::vector<std::uint32_t> candidate_owner_;  ///< owner of the colour beside Z1, where several are drawn as one
  Panes panes_;
  std::vector<bool> drawn_;  ///< whether each segment has instructions
  std::vector<std::uint32_t> values_;
  std::vector<std::uint64_t> enable_;
};

}  // namespace csgsim::observe
