#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/pixel_array.h"
#include "hw/array/stepped_evaluator.h"
#include "hw/pixel_planes/control_word.h"

namespace csgsim::pixel_planes {

/// What lies between a controller's wires and the pixels' memories, clock by clock: the two multiplier trees (thesis
/// fig. 7.1), coefficient bits in at the roots and bits of F out at every pixel; as many registers as bits take to get
/// through them, so that a control word arrives with the bits that entered in its clock; and the pixel processors,
/// which carry out one control word a clock.
class Datapath {
 public:
  /// `shape`: of the whole array. `adders`: where the trees are built adder by adder; else what comes out of them is
  /// worked out of the coefficients, at the same clocks.
  Datapath(array::PlaneShape shape, unsigned register_levels, std::optional<array::SteppedEvaluator> adders,
           array::PixelArray pixels);

  /// From now on the wires carry this. Without a level of the trees they end at the pixels.
  void put(const ControlWord& word, const array::RootBits& bits);

  /// An edge.
  void clock();

  /// Is a word or a bit on the wires or in a register? If not, an edge changes nothing but carried_out().
  [[nodiscard]] bool is_active() const {
    return carries_ || idle_ < length_ || roots_.token.active() || trees_active();
  }
  /// Edges go by while it is not active.
  void rest() { carried_out_ = {}; }

  [[nodiscard]] const ControlWord& control() const { return control_; }  ///< on the controller's wires
  [[nodiscard]] const array::RootBits& roots() const { return roots_; }  ///< beside it
  /// The one at the pixels, which carry it out at the next edge.
  [[nodiscard]] const ControlWord& at_pixels() const { return length_ == 0 ? control_ : delay_[oldest_]; }
  [[nodiscard]] const ControlWord& carried_out() const { return carried_out_; }  ///< at the last edge
  /// Last words of commands that have been carried out.
  [[nodiscard]] std::uint64_t retired() const { return retired_; }

  [[nodiscard]] const array::PixelArray& pixels() const { return pixels_; }
  [[nodiscard]] array::PixelProbe probe(std::uint32_t x, std::uint32_t y) const;

  /// Pixels, and the bits of the trees there.
  void resume(const array::PixelArray& pixels, const array::StreamBit& tree);

  // As array::LinearEvaluator.
  [[nodiscard]] unsigned x_levels() const { return trees_.x_levels(); }
  [[nodiscard]] unsigned y_levels() const { return trees_.y_levels(); }
  [[nodiscard]] array::LevelProbe x_level(unsigned level, array::Place pixel) const {
    return adders_ ? adders_->x_level(level, pixel.x, roots_) : trees_.x_level(level, pixel.x, roots_);
  }
  [[nodiscard]] array::LevelProbe y_level(unsigned level, array::Place pixel) const {
    return adders_ ? adders_->y_level(level, pixel, roots_) : trees_.y_level(level, pixel, roots_);
  }

 private:
  [[nodiscard]] bool trees_active() const { return adders_ ? adders_->any_active() : trees_.any_active(); }
  void carry_out(const ControlWord& word);
  void clock_trees();
  void shift();

  array::LinearEvaluator trees_;
  std::optional<array::SteppedEvaluator> adders_;  ///< in place of them
  array::StreamBit leaves_;                        ///< the registers at the pixels
  array::Words leaf_bits_;                         ///< when adders have brought some: the bits of all pixels, and of
  bool has_leaf_bits_ = false;                     ///< `leaves_` the token alone
  const unsigned length_;                          ///< of the delay
  std::vector<ControlWord> delay_;                 ///< a ring
  std::size_t oldest_ = 0;
  unsigned idle_ = 0;  ///< words without a step that have come into the delay one after another
  ControlWord control_;
  bool carries_ = false;  ///< that is a word with a step
  array::RootBits roots_;
  array::PixelArray pixels_;
  ControlWord carried_out_;
  std::uint64_t retired_ = 0;
};

}  // namespace csgsim::pixel_planes
