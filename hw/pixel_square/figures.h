#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace csgsim::pixel_square {

/// The order in which the squares of a picture are drawn.
enum class SquareOrder : std::uint8_t {
  rows,        ///< from left to right, row after row
  serpentine,  ///< every other row from right to left
  morton,      ///< along a Z-shaped curve, which keeps to a quarter of the picture before it goes on to the next
};

inline constexpr auto square_order_names = std::to_array<std::string_view>({"rows", "serpentine", "morton"});

/// Who divides the model.
enum class DividerKind : std::uint8_t {
  host,        ///< a frame ahead (hw/host): its link brings the commands of the squares
  corners,     ///< a part of the machine, from a model that the link brings (hw/division)
  processors,  ///< graphics processors, a frame ahead: a ring brings the commands of the squares
};

inline constexpr auto divider_kind_names = std::to_array<std::string_view>({"host", "corners", "processors"});

/// As Figures::move_bits: every bit plane at once, in the clock in which the square is drawn.
inline constexpr std::uint32_t all_planes = 0;

/// As Figures::backing_bits: there is no such memory.
inline constexpr std::uint32_t no_backing = 0;

/// As Figures::latch_bits: colours leave one buffer without being latched.
inline constexpr std::uint32_t no_latch = 0;

/// As Figures::ring_channels: as many as send words.
inline constexpr std::uint32_t all_channels = 0;

/// As Figures::refresh_rate: the screen takes nothing.
inline constexpr std::uint32_t not_shown = 0;

/// What only this kind of machine has.
struct Figures {
  std::uint32_t renderers = 1;
  std::uint32_t buffers = 1;             ///< of a renderer: with 2, a finished square moves out while the next is drawn
  std::uint32_t move_bits = all_planes;  ///< bit planes that move from the pixels to the second buffer in a clock
  /// With one buffer: bits of each pixel of a row that are latched in a clock, before the row's colours leave.
  std::uint32_t latch_bits = no_latch;
  /// Of each pixel in the memory behind a renderer, where finished squares wait, in place of the second buffer; or
  /// none.
  std::uint32_t backing_bits = no_backing;
  std::uint32_t backing_width = all_planes;  ///< bits of a square that move there in a clock
  std::uint32_t port_bits = 1;               ///< that a bank of the frame buffer takes, or clears, in a clock
  std::uint32_t port_fifo_depth = 1;         ///< words of each FIFO before the frame buffer
  std::uint32_t banks = 1;                   ///< of the frame buffer; its rows are in them in turn
  std::uint32_t pictures = 1;                ///< that it holds: with 2, one is shown while the other is drawn
  std::uint32_t refresh_rate = not_shown;    ///< pictures a second
  std::uint32_t refresh_bits = 1;            ///< that the screen takes in a turn
  std::uint32_t refresh_clocks = 1;          ///< of a bank, in a turn
  SquareOrder order = SquareOrder::rows;
  bool has_global_or = false;   ///< a renderer's controller learns whether any of its pixels is enabled
  std::uint32_t or_fan_in = 0;  ///< inputs of a gate of that OR; 0: one gate has all, and settles within the clock

  DividerKind divider = DividerKind::host;
  // Of graphics processors, and of the ring that is there with them, in place of the link and of the port.
  std::uint32_t processors = 1;
  std::uint32_t ring_channels = all_channels;  ///< words that it carries at a time
  std::uint32_t ring_bits = 1;                 ///< of such a word
  std::uint32_t ring_word_clocks = 1;          ///< in which a channel carries one

  // Of dividers in the machine, each of which has all that follows.
  std::uint32_t dividers = 1;
  std::uint32_t levels = 1;            ///< with 2, a group of squares first
  std::uint32_t group_side = 1;        ///< squares of a group, along a row and down
  std::uint32_t list_entries = 1;      ///< of the list between the levels
  std::uint32_t model_bits = 1;        ///< of the memory that holds the model
  std::uint32_t record_bits = 1;       ///< that are read from it in a clock
  std::uint32_t halfspaces = 1;        ///< that fit the memory of the surface at hand
  std::uint32_t nodes = 1;             ///< of its tree that do
  std::uint32_t store_words = 1;       ///< of the store for the commands of squares, in link words
  std::uint32_t box_clocks = 1;        ///< to hold a primitive's box against a square's
  std::uint32_t halfspace_clocks = 1;  ///< to test a half-space at four corners
  std::uint32_t cell_clocks = 1;       ///< to hold a half-space of a side against the leaders of a cell
  std::uint32_t node_clocks = 1;       ///< to look at a node of the tree
  std::uint32_t linear_clocks = 1;     ///< to work out a linear instruction, besides its words

  constexpr bool operator==(const Figures&) const = default;
};

/// Finished squares of so many bits of colour a pixel that wait beside the one that is drawn; 0 if they leave from the
/// pixels' own memory.
constexpr std::uint64_t squares_waiting(const Figures& figures, std::uint32_t colour_bits) {
  if (figures.backing_bits == no_backing) return figures.buffers - 1;
  return figures.backing_bits / (colour_bits == 0 ? 1 : colour_bits);
}

/// Whether graphics processors divide the model, and a ring carries all words.
constexpr bool has_ring(const Figures& figures) { return figures.divider == DividerKind::processors; }

/// Bits of a word of colours, and of what a bank of the frame buffer stores in a clock.
constexpr std::uint32_t colour_word_bits(const Figures& figures) {
  return has_ring(figures) ? figures.ring_bits : figures.port_bits;
}

/// Bits of a word of commands, where a link has so many.
constexpr std::uint32_t command_word_bits(const Figures& figures, std::uint32_t link_bits) {
  return has_ring(figures) ? figures.ring_bits : link_bits;
}

/// Bits of what is kept of a half-space at hand (docs/machines/pixel-square.md): with its place among those left in
/// cells of each of 15 sizes.
constexpr std::uint64_t halfspace_entry_bits(const Figures& figures) {
  constexpr std::uint64_t itself = 251;
  constexpr std::uint64_t sizes = 15;
  return itself + sizes * static_cast<std::uint64_t>(std::bit_width(figures.halfspaces - 1));
}

/// Bits of what is kept of a node at hand.
inline constexpr std::uint64_t node_entry_bits = 98;

/// Clocks in which a half-space at hand beyond those that fit their memory is written to that of the model, or read.
constexpr std::uint64_t spilt_halfspace_clocks(const Figures& figures) {
  return (halfspace_entry_bits(figures) + figures.record_bits - 1) / figures.record_bits;
}

/// Clocks in which such a node is written and read.
constexpr std::uint64_t spilt_node_clocks(const Figures& figures) {
  return 2 * ((node_entry_bits + figures.record_bits - 1) / figures.record_bits);
}

}  // namespace csgsim::pixel_square
