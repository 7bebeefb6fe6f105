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

/// Activities of a unit of the pixel-square machine. Each clock of the frame counts for exactly one.
enum class SquareActivity : std::uint8_t {
  /// The host sends the model; a divider receives the model, tests or writes; a sender sends; a renderer clears, draws
  /// or moves a square; the frame buffer stores.
  working,
  waiting_for_host,          ///< the first word has not left the host, or the model has not arrived
  waiting_for_divider,       ///< the model FIFO is full, no square is in the store, or no complete command has arrived
  waiting_for_renderer,      ///< the store or the FIFO of the chosen renderer is full, or no colours have arrived
  waiting_for_frame_buffer,  ///< the FIFO of clear headers is full, or a finished square has not moved out
  done,                      ///< no work is left; for a renderer, every clock after its last square has left the pixels
  refreshing,                ///< frame buffer only: the screen reads the memory, and nothing is stored
  waiting_for_ring,          ///< graphics processors only: words wait for the ring
};

inline constexpr auto square_activity_names =
    std::to_array<std::string_view>({"working", "waiting_for_host", "waiting_for_divider", "waiting_for_renderer",
                                     "waiting_for_frame_buffer", "done", "refreshing", "waiting_for_ring"});

constexpr std::string_view name_of(SquareActivity activity) {
  return square_activity_names.at(static_cast<std::size_t>(activity));
}

/// Clocks of one unit by activity; their sum is the frame's clocks.
using SquareClocks = machines::ClockTally<SquareActivity, square_activity_names.size()>;

/// Returns `counted_clocks`, completed to `frame_clocks` clocks: the remaining clocks are added to `rest_activity`.
SquareClocks complete_clocks(SquareClocks counted_clocks, SquareActivity rest_activity, std::uint64_t frame_clocks);

/// Counts of the ring in one frame.
struct RingAccount {
  SquareClocks clocks;      ///< the ring is working while at least one channel carries a word
  std::uint64_t words = 0;  ///< number of words carried
  /// Clocks in which every channel carried a word, or the frame buffer accepted as many words as it can.
  std::uint64_t full_clocks = 0;

  bool operator==(const RingAccount&) const = default;
};

/// Counts of a pixel-square machine in one frame.
struct SquareAccount {
  std::uint64_t squares_drawn = 0;
  std::uint64_t squares_skipped = 0;            ///< empty squares, cleared by the frame buffer
  SquareClocks host{};                          ///< only without graphics processors
  std::vector<SquareClocks> processors;         ///< only with graphics processors
  std::optional<RingAccount> ring;              ///< only with graphics processors
  std::vector<SquareClocks> dividers;           ///< only with dividers in the machine
  std::optional<SquareClocks> sender;           ///< with dividers only: the unit that sends the stored squares
  std::vector<SquareClocks> renderers;          ///< pixel processors of each renderer, without its output buffer
  std::vector<std::uint64_t> renderer_squares;  ///< squares drawn by each renderer
  SquareClocks frame_buffer{};

  bool operator==(const SquareAccount&) const = default;
};

/// Converts the counts to the account that statistics and reports show.
machines::Account account(const SquareAccount& counts);

}  // namespace csgsim::pixel_square
