// Run-time outcomes that exact timing needs.
// Used by hw/bit_serial_memory, hw/multi_processor, hw/systemc, sim/engine and sim/rows.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace csgsim::machines {

/// A skip_if_none that found no enabled pixel and therefore skipped instructions.
struct Skip {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< index of the skip_if_none within the segment

  constexpr bool operator==(const Skip&) const = default;
};

/// The enabled pixels of a segment at each of its instructions. A plane has one bit per pixel: pixel x of a row is bit
/// x % 64 of word x / 64; rows are padded to whole words with zeros.
struct PixelActivity {
  /// Plane numbers for one instruction.
  struct Planes {
    std::uint32_t enabled = 0;  ///< pixels with E = 1 when the instruction began
    /// For keep_max and keep_min, the enabled pixels that stored F; for other instructions equal to `enabled`.
    std::uint32_t chosen = 0;

    constexpr bool operator==(const Planes&) const = default;
  };

  std::size_t row_words = 0;
  std::vector<std::vector<std::uint64_t>> planes{{}};  ///< the first plane has no words and represents 0 at every pixel
  std::vector<Planes> instructions;                    ///< one per instruction

  bool operator==(const PixelActivity&) const = default;
};

/// Clocks that the processors spend on an instruction, summed over the pixels of a segment.
struct PixelClocks {
  std::uint64_t all = 0;
  std::uint64_t enabled = 0;  ///< part of `all` at pixels that were enabled when the instruction began

  constexpr bool operator==(const PixelClocks&) const = default;
};

/// Run-time outcomes that exact timing needs.
struct RunOutcome {
  std::span<const Skip> skips;  ///< in program order
  /// Enabled pixels of each segment; empty without a run, or if the clocks do not depend on the enabled pixels.
  std::span<const PixelActivity> pixel_activity;

  constexpr RunOutcome() = default;
  constexpr RunOutcome(std::span<const Skip> all_skips, std::span<const PixelActivity> all_met)
      : skips(all_skips), pixel_activity(all_met) {}
  template <class Skips>
  requires std::convertible_to<const Skips&, std::span<const Skip>>
  constexpr RunOutcome(const Skips& all_skips) : skips(all_skips) {}
};

/// An owning copy of RunOutcome.
struct RunRecord {
  std::vector<Skip> skips;
  std::vector<PixelActivity> pixel_activity;

  [[nodiscard]] RunOutcome outcome() const { return {skips, pixel_activity}; }
};

}  // namespace csgsim::machines
