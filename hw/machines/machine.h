#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::machines {

/// One figure of a machine description, with where it comes from.
struct Figure {
  std::string key;         ///< as in the file, for instance `array.width`
  std::string value;       ///< as text
  std::string unit;        ///< may be empty
  std::string provenance;  ///< `published` or `assumed`
  std::string source;      ///< the publication, or why it is assumed so
};

/// What a machine's processors are spread over at a time.
enum class Kind : std::uint8_t {
  frame_buffer,  ///< the whole picture (thesis 7.2.1)
  scan_line,     ///< a line of it: a systolic chain of word-wide cells (7.2.2)
  pixel_square,  ///< a square of it, drawn and moved to a frame buffer (7.2.3)
};

inline constexpr auto kind_names = std::to_array<std::string_view>({"frame-buffer", "scan-line", "pixel-square"});

constexpr std::string_view name_of(Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

/// Width and height of a picture, pixels.
struct Size {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  constexpr bool operator==(const Size&) const = default;
};

/// What only Kind::scan_line has.
struct ScanLine {
  std::uint32_t words = 0;            ///< of a cell's memory
  std::uint32_t word_bits = 0;        ///< of each of them, and of the cell's adder
  std::uint32_t chains = 1;           ///< lines worked on in parallel, each by a chain of its own
  std::uint32_t packet_interval = 1;  ///< clocks from a packet's entry to that of the next
  std::uint32_t refresh_hz = 0;       ///< fields a second that the screen shows
  bool interlaced = false;            ///< a field is every other line, even lines first

  constexpr bool operator==(const ScanLine&) const = default;
};

/// The order in which the squares of a picture are drawn.
enum class SquareOrder : std::uint8_t {
  rows,        ///< from left to right, row after row
  serpentine,  ///< every other row from right to left
  morton,      ///< along a Z-shaped curve, which keeps to a quarter of the picture before it goes on to the next
};

inline constexpr auto square_order_names = std::to_array<std::string_view>({"rows", "serpentine", "morton"});

/// What only Kind::pixel_square has.
struct PixelSquare {
  std::uint32_t renderers = 1;
  std::uint32_t buffers = 1;           ///< of a renderer: with 2, a finished square moves out while the next is drawn
  std::uint32_t fifo_depth = 1;        ///< words of every FIFO
  std::uint32_t port_bits = 1;         ///< colour bits that the frame buffer takes in a clock
  std::uint32_t host_word_clocks = 1;  ///< from one word of the model to the next
  std::uint32_t primitive_clocks = 1;  ///< of the divider, to hold a primitive's bounds against a square
  std::uint32_t halfspace_clocks = 1;  ///< of the divider, to hold a half-space against a square's corners
  SquareOrder order = SquareOrder::rows;

  constexpr bool operator==(const PixelSquare&) const = default;
};

/// A logic-enhanced frame buffer, as its description in hw/machines/NAME.toml says.
struct Machine {
  std::string name;
  std::string description;
  Kind kind = Kind::frame_buffer;
  isa::ArrayShape array;           ///< pixel processors (of one chain, of one renderer) and memory bits of each
  Size picture;                    ///< where the array is not the whole of it
  std::uint64_t clock_hz = 0;      ///< instruction bit steps, or packets, a second
  std::uint32_t memory_reads = 1;  ///< reads of pixel memory a clock: 1 or 2
  std::uint32_t alu_bits = 1;      ///< adjacent bits of a field that the ALU works on, and a port delivers, in a clock
  bool has_global_or = true;       ///< the controller learns whether any pixel is enabled; see answers()
  ScanLine scan_line;
  PixelSquare pixel_square;
  std::vector<Figure> figures;  ///< every figure of the file, in its order
};

/// Whether the controller learns if any pixel is enabled. A chain of cells and a renderer have no such line.
bool answers(const Machine& machine);

/// Pixels of the picture that the machine draws.
Size picture_size(const Machine& machine);

/// Makes the machine draw a picture of that size: an array that holds the whole of it becomes as large. Throws
/// InputError where its lines are longer than a chain of cells.
void set_picture_size(Machine& machine, Size size);

/// Makes the machine draw the Program's picture with its memory. Throws as set_picture_size does.
void adopt(Machine& machine, const isa::Program& program);

/// Names of the machines that come with csgsim.
std::vector<std::string_view> built_in_names();

/// Does the name stand for a file that describes a machine?
bool is_file(std::string_view name_or_file);

/// A built-in machine by name, or one described in a file (anything ending in .toml). Throws InputError: an unknown
/// name (with the nearest one), unknown key, wrong type, value out of range, each with file:line:column.
Machine load(const std::string& name_or_file);

}  // namespace csgsim::machines
