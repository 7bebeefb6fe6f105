#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "hw/machines/accounts.h"
#include "hw/machines/clock_tally.h"

namespace csgsim::pixel_square {

/// Where a part of the pixel-square machine spends its clocks. Every clock of the frame is in one of these.
#define CSGSIM_SQUARE_ACTIVITIES(A)                                                                 \
  A(working, "sending or taking the model; testing, sending; clearing, drawing, moving; storing")   \
  A(waiting_for_host, "the first word has not left the host, or the model has not arrived")         \
  A(waiting_for_divider, "the FIFO of the model is full, or no whole command has arrived")          \
  A(waiting_for_renderer, "the FIFO of the renderer chosen is full, or no colours have arrived")    \
  A(waiting_for_frame_buffer, "the FIFO of clears is full, or a finished square has not moved out") \
  A(done, "nothing is left to do; of a renderer, all after its last square has left the pixels")

enum class SquareActivity : std::uint8_t {
#define CSGSIM_SQUARE_ACTIVITY_ENUMERATOR(name, meaning) name,
  CSGSIM_SQUARE_ACTIVITIES(CSGSIM_SQUARE_ACTIVITY_ENUMERATOR)
#undef CSGSIM_SQUARE_ACTIVITY_ENUMERATOR
};

struct SquareActivityInfo {
  std::string_view name;
  std::string_view meaning;
};

inline constexpr auto square_activities = std::to_array<SquareActivityInfo>({
#define CSGSIM_SQUARE_ACTIVITY_ROW(name, meaning) SquareActivityInfo{#name, meaning},
    CSGSIM_SQUARE_ACTIVITIES(CSGSIM_SQUARE_ACTIVITY_ROW)
#undef CSGSIM_SQUARE_ACTIVITY_ROW
});

constexpr std::string_view name_of(SquareActivity activity) {
  return square_activities[static_cast<std::size_t>(activity)].name;
}

/// Clocks of one part by activity; they add up to the frame's.
using SquareClocks = machines::ClockTally<SquareActivity, square_activities.size()>;

/// The clocks of a frame of so many: in those that are not accounted for a part was at `rest`.
SquareClocks whole(SquareClocks counted, SquareActivity rest, std::uint64_t clocks);

/// How the frame of a pixel-square machine went by.
struct SquareAccount {
  std::uint64_t squares_drawn = 0;
  std::uint64_t squares_skipped = 0;  ///< that nothing touches: cleared by the frame buffer
  SquareClocks host{};
  std::optional<SquareClocks> divider;          ///< of a machine that has one
  std::vector<SquareClocks> renderers;          ///< of the pixel processors of each, not of its output buffer
  std::vector<std::uint64_t> renderer_squares;  ///< drawn by each
  SquareClocks frame_buffer{};

  bool operator==(const SquareAccount&) const = default;
};

/// As it is told.
machines::Account account(const SquareAccount& counted);

}  // namespace csgsim::pixel_square
