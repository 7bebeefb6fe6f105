#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace csgsim::pixel_square {

/// Order in which the squares of a picture are drawn.
enum class SquareOrder : std::uint8_t {
  rows,        ///< left to right, row after row
  serpentine,  ///< every other row from right to left
  morton,      ///< along a Z-shaped curve that completes one quarter of the picture before the next
};

inline constexpr auto square_order_names = std::to_array<std::string_view>({"rows", "serpentine", "morton"});

/// Unit that divides the model.
enum class DividerKind : std::uint8_t {
  host,        ///< the host, one frame ahead (hw/host): its link transfers the commands of the squares
  corners,     ///< a divider in the machine, from a model that the link transfers (hw/division)
  processors,  ///< graphics processors, one frame ahead: a ring transfers the commands of the squares
};

inline constexpr auto divider_kind_names = std::to_array<std::string_view>({"host", "corners", "processors"});

/// Value of Figures::move_bits: every bit plane moves at once, in the clock in which the square is drawn.
inline constexpr std::uint32_t all_planes = 0;

/// Value of Figures::backing_bits: there is no backing memory.
inline constexpr std::uint32_t no_backing = 0;

/// Value of Figures::latch_bits: with one buffer, colours leave without being latched.
inline constexpr std::uint32_t no_latch = 0;

/// Value of Figures::ring_channels: one channel per source.
inline constexpr std::uint32_t all_channels = 0;

/// Value of Figures::refresh_rate: the screen does not read the frame buffer.
inline constexpr std::uint32_t not_shown = 0;

/// Parameters that only this kind of machine has.
struct Figures {
  std::uint32_t renderers = 1;
  std::uint32_t buffers = 1;  ///< buffers per renderer; with 2, a finished square moves out while the next is drawn
  std::uint32_t move_bits = all_planes;  ///< bit planes moved per clock from the pixels to the second buffer
  /// Bits of each pixel of a row latched per clock before the row's colours leave; used with one buffer only.
  std::uint32_t latch_bits = no_latch;
  /// Bits per pixel of the memory in which a renderer's finished squares wait, in place of the second buffer.
  std::uint32_t backing_bits = no_backing;
  std::uint32_t backing_width = all_planes;  ///< bits of a square moved to the backing memory per clock
  std::uint32_t port_bits = 1;               ///< bits that a bank of the frame buffer stores or clears per clock
  std::uint32_t port_fifo_depth = 1;         ///< words of each FIFO before the frame buffer
  std::uint32_t banks = 1;                   ///< banks of the frame buffer; rows are interleaved over them
  std::uint32_t pictures = 1;  ///< pictures that the frame buffer holds; with 2, one is shown while the other is drawn
  std::uint32_t refresh_rate = not_shown;  ///< pictures per second read by the screen
  std::uint32_t refresh_bits = 1;          ///< bits that the screen reads per turn
  std::uint32_t refresh_clocks = 1;        ///< clocks for which a bank is occupied by a turn
  SquareOrder order = SquareOrder::rows;
  /// Whether a global OR reports to a renderer's controller if any of its pixels is enabled.
  bool has_global_or = false;
  std::uint32_t or_fan_in = 0;  ///< inputs of one gate of that OR; 0: a single gate, which settles within the clock

  DividerKind divider = DividerKind::host;
  // Graphics processors, and the ring that replaces the link and the ports to the frame buffer.
  std::uint32_t processors = 1;
  std::uint32_t ring_channels = all_channels;  ///< words carried concurrently
  std::uint32_t ring_bits = 1;                 ///< bits of a ring word
  std::uint32_t ring_word_clocks = 1;          ///< clocks in which a channel carries one word

  // Dividers in the machine; each has the following resources.
  std::uint32_t dividers = 1;
  std::uint32_t levels = 1;            ///< with 2, the model is first divided for a group of squares
  std::uint32_t group_side = 1;        ///< side of a group, in squares
  std::uint32_t list_entries = 1;      ///< capacity of the list of primitives and half-spaces that remain for a group
  std::uint32_t model_bits = 1;        ///< bits of the memory that holds the model
  std::uint32_t record_bits = 1;       ///< bits read from that memory per clock
  std::uint32_t halfspaces = 1;        ///< capacity of the half-space memory of the current surface
  std::uint32_t nodes = 1;             ///< capacity of the node memory of the current surface's tree
  std::uint32_t store_words = 1;       ///< capacity of the store for the commands of squares, in link words
  std::uint32_t box_clocks = 1;        ///< clocks to compare a primitive's box with a square's
  std::uint32_t halfspace_clocks = 1;  ///< clocks to test a half-space at four corners
  std::uint32_t cell_clocks = 1;       ///< clocks to compare a half-space with the leaders of a cell
  std::uint32_t node_clocks = 1;       ///< clocks to visit a node of the tree
  std::uint32_t linear_clocks = 1;     ///< clocks to compute a linear instruction, in addition to its words

  constexpr bool operator==(const Figures&) const = default;
};

/// Maximum number of finished squares, with `colour_bits` bits of colour per pixel, that can wait for the frame buffer
/// while another square is drawn; 0 if squares leave from the pixels' own memory.
constexpr std::uint64_t waiting_square_capacity(const Figures& figures, std::uint32_t colour_bits) {
  if (figures.backing_bits == no_backing) return figures.buffers - 1;
  return figures.backing_bits / (colour_bits == 0 ? 1 : colour_bits);
}

/// Whether graphics processors divide the model and a ring carries all words.
constexpr bool has_ring(const Figures& figures) { return figures.divider == DividerKind::processors; }

/// Bits of a word of colours, and of the data that a bank of the frame buffer stores per clock.
constexpr std::uint32_t colour_word_bits(const Figures& figures) {
  return has_ring(figures) ? figures.ring_bits : figures.port_bits;
}

/// Bits of a word of commands; `link_bits` is the width of the link.
constexpr std::uint32_t command_word_bits(const Figures& figures, std::uint32_t link_bits) {
  return has_ring(figures) ? figures.ring_bits : link_bits;
}

/// Bits stored for each half-space of the current surface (docs/machines/pixel-square.md): 251 for the half-space, and
/// an index for each of 15 cell sizes: the half-space's position in the list of half-spaces that remain in a cell of
/// that size.
constexpr std::uint64_t halfspace_entry_bits(const Figures& figures) {
  constexpr std::uint64_t itself = 251;
  constexpr std::uint64_t sizes = 15;
  return itself + sizes * static_cast<std::uint64_t>(std::bit_width(figures.halfspaces - 1));
}

/// Bits stored for each node of the current surface's tree.
inline constexpr std::uint64_t node_entry_bits = 98;

/// Clocks to write a half-space that does not fit its memory to the model memory, or to read it from there.
constexpr std::uint64_t spilt_halfspace_clocks(const Figures& figures) {
  return (halfspace_entry_bits(figures) + figures.record_bits - 1) / figures.record_bits;
}

/// Clocks to write a node that does not fit its memory to the model memory and to read it back.
constexpr std::uint64_t spilt_node_clocks(const Figures& figures) {
  return 2 * ((node_entry_bits + figures.record_bits - 1) / figures.record_bits);
}

}  // namespace csgsim::pixel_square
