// The clocked path from the controller's wires to the pixels' memories.
// Used by PixelPipeline.
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

/// The path from the controller's wires to the pixels' memories, clock by clock. It consists of the two multiplier
/// trees (thesis fig. 7.1), which turn coefficient bits at the roots into bits of F at every pixel; a delay line as
/// long as the trees, so that a control word arrives with the bits that entered in its clock; and the pixel processors,
/// which execute one control word per clock.
class Datapath {
 public:
  /// `shape` is that of the whole array. If `adders` is present, the trees are simulated adder by adder; otherwise
  /// their outputs are computed from the coefficients, in the same clocks.
  Datapath(array::PlaneShape shape, unsigned register_levels, std::optional<array::SteppedEvaluator> adders,
           array::PixelArray pixels);

  /// Sets the wires for this and the following clocks. Without tree levels they end at the pixels.
  void put(const ControlWord& word, const array::RootBits& bits);

  /// Advances by one clock edge.
  void clock();

  /// Whether a word or a bit is on the wires or in a register. Otherwise, an edge changes only last_executed().
  [[nodiscard]] bool is_active() const {
    return carries_ || idle_ < length_ || roots_.token.active() || trees_active();
  }
  /// Advances by any number of idle edges; requires !is_active().
  void rest() { last_executed_ = {}; }

  [[nodiscard]] const ControlWord& control() const { return control_; }  ///< word on the controller's wires
  [[nodiscard]] const array::RootBits& roots() const { return roots_; }  ///< tree bits sent with that word
  /// The word at the pixels, which execute it at the next edge.
  [[nodiscard]] const ControlWord& at_pixels() const { return length_ == 0 ? control_ : delay_[oldest_]; }
  [[nodiscard]] const ControlWord& last_executed() const { return last_executed_; }  ///< executed at the last edge
  /// Number of commands whose last word has been executed.
  [[nodiscard]] std::uint64_t retired() const { return retired_; }

  [[nodiscard]] const array::PixelArray& pixels() const { return pixels_; }
  [[nodiscard]] array::PixelProbe probe(std::uint32_t x, std::uint32_t y) const;

  /// Replaces the state of the pixels, and the tree bits in the registers at the pixels.
  void resume(const array::PixelArray& pixels, const array::StreamBit& tree);

  // Signals as in array::LinearEvaluator.
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
  void execute_word(const ControlWord& word);
  void clock_trees();
  void shift();

  array::LinearEvaluator trees_;
  std::optional<array::SteppedEvaluator> adders_;  ///< replaces trees_ if present
  array::StreamBit leaves_;                        ///< registers at the pixels
  array::Words leaf_bits_;                         ///< tree bits of all pixels; valid if has_leaf_bits_
  /// Whether adders_ has produced leaf_bits_; if so, only the token of leaves_ is valid.
  bool has_leaf_bits_ = false;
  const unsigned length_;           ///< length of the delay line
  std::vector<ControlWord> delay_;  ///< ring
  std::size_t oldest_ = 0;
  unsigned idle_ = 0;  ///< number of idle words since the last active word entered the delay line
  ControlWord control_;
  bool carries_ = false;  ///< whether control_ is not an idle word
  array::RootBits roots_;
  array::PixelArray pixels_;
  ControlWord last_executed_;
  std::uint64_t retired_ = 0;
};

}  // namespace csgsim::pixel_planes
