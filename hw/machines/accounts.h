#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

namespace csgsim::machines {

/// How the frame of a scan-line array went by. Clocks count from the first in which a packet's word is entering. A line
/// is its packets, one an instruction, and a mark, which is one word long. The clocks of the chain that ends last are
/// its part of entry_clocks and refresh_clocks, and drain_clocks.
struct LineAccount {
  std::uint64_t lines = 0;
  std::uint64_t packets = 0;         ///< in all, without the marks
  std::uint64_t most_packets = 0;    ///< of a line
  std::uint64_t line_budget = 0;     ///< clocks that the refresh gives a line, times the chains that share the lines
  std::uint64_t late_lines = 0;      ///< lines whose words alone take more than that to enter
  std::uint64_t entry_clocks = 0;    ///< in which a word was entering a chain, summed over the chains
  std::uint64_t refresh_clocks = 0;  ///< in which a mark waited for the refresh path, summed over the chains
  std::uint64_t fill_clocks = 0;     ///< until a packet or mark was in the last cell of a line for the first time
  std::uint64_t drain_clocks = 0;    ///< from the last mark's entry until the last colour was at the refresh port
  std::uint64_t busy_cells = 0;      ///< clocks in which a packet's word was in a cell, summed over the lines' cells

  bool operator==(const LineAccount&) const = default;
};

/// Where a part of the pixel-square machine spends its clocks. Every clock of the frame is in one of these.
#define CSGSIM_SQUARE_ACTIVITIES(A)                                                                 \
  A(working, "sending or taking the model; testing, sending; drawing; storing or clearing")         \
  A(waiting_for_host, "the model has not arrived yet")                                              \
  A(waiting_for_divider, "the FIFO of the model is full, or no instruction has arrived")            \
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

/// Clocks of one part by activity; they add up to the frame's.
using SquareClocks = std::array<std::uint64_t, square_activities.size()>;

/// How the frame of a pixel-square machine went by.
struct SquareAccount {
  std::uint64_t squares_drawn = 0;
  std::uint64_t squares_skipped = 0;  ///< that nothing touches: cleared in the frame buffer
  SquareClocks host{};
  SquareClocks divider{};
  std::vector<SquareClocks> renderers;          ///< of the pixel processors of each, not of its output buffer
  std::vector<std::uint64_t> renderer_squares;  ///< drawn by each
  SquareClocks frame_buffer{};

  bool operator==(const SquareAccount&) const = default;
};

/// What a machine of the Program's kind tells of the frame besides its clocks.
using Account = std::variant<std::monostate, LineAccount, SquareAccount>;

}  // namespace csgsim::machines
