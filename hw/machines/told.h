#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace csgsim::machines {

/// A skip_if_none that found no pixel enabled, so that the instructions it names were not carried out.
struct Skip {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< of the question within the segment

  constexpr bool operator==(const Skip&) const = default;
};

/// Which pixels of a segment its instructions met. A plane has a bit a pixel: pixel x of a row is bit x % 64 of word
/// x / 64, each row padded to whole words with zeros.
struct MetPixels {
  /// Numbers of planes.
  struct Planes {
    std::uint32_t enabled = 0;  ///< pixels whose E was 1 when the instruction began
    std::uint32_t chosen = 0;   ///< of these, at keep_max and keep_min, where F was kept; else the same

    constexpr bool operator==(const Planes&) const = default;
  };

  std::size_t row_words = 0;
  std::vector<std::vector<std::uint64_t>> planes{{}};  ///< the first, without words, is 0 at every pixel
  std::vector<Planes> instructions;                    ///< one an instruction

  bool operator==(const MetPixels&) const = default;
};

/// Clocks that the processors of a segment's pixels spend at them on an instruction.
struct PixelClocks {
  std::uint64_t all = 0;
  std::uint64_t enabled = 0;  ///< of these, at pixels whose E was 1 when it began

  constexpr bool operator==(const PixelClocks&) const = default;
};

/// What decides about the clocks of a Program and only a run tells.
struct Told {
  std::span<const Skip> skips;     ///< in program order
  std::span<const MetPixels> met;  ///< one a segment; none where no run told, or Kind::asks_for_pixels does not ask

  constexpr Told() = default;
  constexpr Told(std::span<const Skip> all_skips, std::span<const MetPixels> all_met)
      : skips(all_skips), met(all_met) {}
  template <class Skips>
  requires std::convertible_to<const Skips&, std::span<const Skip>>
  constexpr Told(const Skips& all_skips) : skips(all_skips) {}
};

/// The same, kept.
struct RunRecord {
  std::vector<Skip> skips;
  std::vector<MetPixels> met;

  [[nodiscard]] Told told() const { return {skips, met}; }
};

}  // namespace csgsim::machines
