#pragma once

#include <span>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/display_model.h"
#include "hw/isa/link_word.h"

namespace csgsim::division {

/// Widths in bits of what a display model is sent as. Those without a value are the least that hold the model's own
/// numbers; the header says them.
struct Widths {
  static constexpr unsigned count = 32;  ///< of planes, of primitives, of nodes
  static constexpr unsigned side = 15;   ///< a number of pixels, 0 to 2^14
  static constexpr unsigned bits = 5;    ///< a number of bits, of depth, fraction, colour, an index
  static constexpr unsigned width = 6;   ///< a width of more than 31 bits
  static constexpr unsigned place = 13;  ///< a bit of pixel memory, or the end of it

  unsigned slope = 1;       ///< A and B, two's complement
  unsigned constant = 1;    ///< C, two's complement
  unsigned plane = 0;       ///< an index of a plane
  unsigned halfspaces = 0;  ///< the number of a primitive's half-spaces
  unsigned operands = 0;    ///< the number of an operator's operands
  unsigned depth = 0;       ///< a depth step or the end of the range: z_bits + 1
  unsigned colour = 0;

  /// Counts, sides of the picture, sampling and the widths below, fields, the background.
  [[nodiscard]] unsigned header() const { return 3 * count + 2 * side + 5 * bits + 3 * width + 7 * place + 1 + colour; }
  [[nodiscard]] unsigned plane_record() const { return 1 + 2 * slope + constant; }
  /// Without the colour at depth 0, which one that is not complemented has.
  [[nodiscard]] unsigned primitive_record() const { return 4 * side + 2 * depth + 2 + halfspaces; }
  /// Without the colour, which one that is seen has.
  [[nodiscard]] unsigned halfspace_record() const { return plane + 1; }
  /// Without what an operator has: itself and the number of its operands.
  static constexpr unsigned node_record = 1;
};

Widths widths_of(const DisplayModel& model);

/// The stream that the host sends. Throws InputError if the model is not sound.
Bits encode(const DisplayModel& model);

/// Throws InputError unless the stream is one that encode() writes, to the bit.
DisplayModel decode(const Bits& bits);

/// The stream in the words of a link of 1 to 256 bits, link_words() of them. The last is filled up with 0.
std::vector<isa::LinkWord> to_link(const Bits& bits, unsigned width);

/// The model of which these are all the words. Throws InputError unless they are to_link() of what encode() writes.
DisplayModel from_link(std::span<const isa::LinkWord> words, unsigned width);

}  // namespace csgsim::division
