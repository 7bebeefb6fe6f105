// Records at which pixels instructions take effect.
// Used by sim/functional and sim/reference.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"
#include "hw/machines/kind.h"
#include "hw/machines/run_outcome.h"
#include "sim/engine/engine.h"
#include "sim/engine/numbers.h"

namespace csgsim::engine {

/// Records at which pixels the instructions of a run take effect, if the machine's kind needs that. It is called right
/// before and right after every instruction.
class PixelActivityRecorder {
 public:
  PixelActivityRecorder(const isa::Program& program, const machines::Machine& machine)
      : is_needed_(machine.kind->depends_on_pixels(machine)) {
    if (is_needed_) met_.resize(program.segments.size());
  }

  [[nodiscard]] bool is_needed() const { return is_needed_; }
  /// The records of all segments; null if a part of the run was not recorded.
  [[nodiscard]] const std::vector<machines::PixelActivity>* pixel_activity() const {
    return is_whole_ ? &met_ : nullptr;
  }
  /// The record of one segment; instructions that were not recorded appear without pixels.
  [[nodiscard]] const machines::PixelActivity& pixel_activity(std::uint32_t segment) const { return met_[segment]; }
  /// Called when the run continues from another place.
  void jump() {
    is_whole_ = !is_needed_;
    has_enabled_ = false;
  }

  /// Reads what the record of an instruction needs before the instruction is executed.
  void before(Place place, const isa::Instruction& instruction, const PixelState& state) {
    if (!is_needed_) return;
    if (place.index == 0 || !has_enabled_) begin(place, state);
    if (is_selective(instruction)) read(instruction.fields[0], state, before_);
  }

  void after(Place place, const isa::Instruction& instruction, const PixelState& state) {
    if (!is_needed_) return;
    machines::PixelActivity& pixel_activity = met_[place.segment];
    pixel_activity.instructions.push_back({plane_, plane_});
    if (isa::info(instruction.opcode).enable_effect == isa::EnableEffect::keeps) return;
    after_.resize(enabled_.size());
    state.read_enable(after_);
    if (is_selective(instruction))
      pixel_activity.instructions.back().chosen = find_changed(pixel_activity, instruction.fields[0], state);
    if (after_ == enabled_) return;
    std::swap(enabled_, after_);
    plane_ = add_plane(pixel_activity, enabled_);
  }

 private:
  static constexpr std::uint32_t word_bits = 64;

  static bool is_selective(const isa::Instruction& instruction) {
    return instruction.opcode == isa::Opcode::keep_max || instruction.opcode == isa::Opcode::keep_min;
  }

  static void read(isa::Field field, const PixelState& state, std::vector<std::uint32_t>& values) {
    const isa::Region region = state.region();
    values.resize(std::size_t{region.width} * region.height);
    state.read_field(field, values);
  }

  static std::uint32_t add_plane(machines::PixelActivity& pixel_activity, const std::vector<std::uint64_t>& words) {
    if (std::all_of(words.begin(), words.end(), [](std::uint64_t word) { return word == 0; })) return 0;
    pixel_activity.planes.push_back(words);
    return static_cast<std::uint32_t>(pixel_activity.planes.size() - 1);
  }

  void begin(Place place, const PixelState& state) {
    const isa::Region region = state.region();
    machines::PixelActivity& pixel_activity = met_[place.segment];
    pixel_activity = {};
    pixel_activity.row_words = quotient_up(region.width, word_bits);
    pixel_activity.instructions.resize(place.index);
    enabled_.resize(pixel_activity.row_words * region.height);
    state.read_enable(enabled_);
    plane_ = add_plane(pixel_activity, enabled_);
    has_enabled_ = true;
  }

  /// Index of the plane of pixels whose value changes, or does not fit and therefore disables the pixel.
  std::uint32_t find_changed(machines::PixelActivity& pixel_activity, isa::Field field, const PixelState& state) {
    read(field, state, values_);
    const isa::Region region = state.region();
    std::vector<std::uint64_t> words(enabled_.size());
    for (std::uint32_t y = 0; y < region.height; ++y) {
      for (std::uint32_t x = 0; x < region.width; ++x) {
        const std::size_t pixel = std::size_t{y} * region.width + x;
        words[y * pixel_activity.row_words + x / word_bits] |= std::uint64_t{values_[pixel] != before_[pixel]}
                                                               << x % word_bits;
      }
    }
    for (std::size_t i = 0; i < words.size(); ++i) words[i] |= enabled_[i] & ~after_[i];
    return words == enabled_ ? plane_ : add_plane(pixel_activity, words);
  }

  bool is_needed_;
  bool is_whole_ = true;
  bool has_enabled_ = false;  ///< `enabled_` is up to date
  std::vector<machines::PixelActivity> met_;
  std::vector<std::uint64_t> enabled_;  ///< enabled pixels before the instruction
  std::vector<std::uint64_t> after_;    ///< enabled pixels after it
  std::uint32_t plane_ = 0;             ///< index of the plane of `enabled_`
  std::vector<std::uint32_t> before_;   ///< values of a target before the instruction
  std::vector<std::uint32_t> values_;
};

}  // namespace csgsim::engine
