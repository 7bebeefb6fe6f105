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
enum class SquareActivity : std::uint8_t {
  working,               ///< sending or taking the model; testing, writing, sending; clearing, drawing, moving; storing
  waiting_for_host,      ///< the first word has not left the host, or the model has not arrived
  waiting_for_divider,   ///< the FIFO of the model is full, no square is in the store, or no whole command has come
  waiting_for_renderer,  ///< the store or the FIFO of the renderer chosen is full, or no colours have arrived
  waiting_for_frame_buffer,  ///< the FIFO of clears is full, or a finished square has not moved out
  done,                      ///< nothing is left to do; of a renderer, all after its last square has left the pixels
  refreshing,                ///< the frame buffer alone: the screen takes a turn, and nothing is stored
  waiting_for_ring,          ///< a graphics processor alone: its words wait for the ring
};

inline constexpr auto square_activity_names =
    std::to_array<std::string_view>({"working", "waiting_for_host", "waiting_for_divider", "waiting_for_renderer",
                                     "waiting_for_frame_buffer", "done", "refreshing", "waiting_for_ring"});

constexpr std::string_view name_of(SquareActivity activity) {
  return square_activity_names.at(static_cast<std::size_t>(activity));
}

/// Clocks of one part by activity; they add up to the frame's.
using SquareClocks = machines::ClockTally<SquareActivity, square_activity_names.size()>;

/// The clocks of a frame of so many: in those that are not accounted for a part was at `rest`.
SquareClocks whole(SquareClocks counted, SquareActivity rest, std::uint64_t clocks);

/// How a frame of the ring went by.
struct RingAccount {
  SquareClocks clocks;            ///< working: some channel carries a word
  std::uint64_t words = 0;        ///< that it carried
  std::uint64_t full_clocks = 0;  ///< in which every channel carried one, or the frame buffer took all it could

  bool operator==(const RingAccount&) const = default;
};

/// How the frame of a pixel-square machine went by.
struct SquareAccount {
  std::uint64_t squares_drawn = 0;
  std::uint64_t squares_skipped = 0;            ///< that nothing touches: cleared by the frame buffer
  SquareClocks host{};                          ///< of a machine without graphics processors
  std::vector<SquareClocks> processors;         ///< of a machine that has some
  std::optional<RingAccount> ring;              ///< the same
  std::vector<SquareClocks> dividers;           ///< of a machine that has some
  std::optional<SquareClocks> sender;           ///< the same: of what sends the squares that these have stored
  std::vector<SquareClocks> renderers;          ///< of the pixel processors of each, not of its output buffer
  std::vector<std::uint64_t> renderer_squares;  ///< drawn by each
  SquareClocks frame_buffer{};

  bool operator==(const SquareAccount&) const = default;
};

/// As it is told.
machines::Account account(const SquareAccount& counted);

}  // namespace csgsim::pixel_square
