// Binary encoding of a display model, as sent over a link.
// Used by hw/multi_processor, hw/pixel_square and host/emit.
#pragma once

#include <span>
#include <vector>

#include "hw/division/bit_stream.h"
#include "hw/division/display_model.h"
#include "hw/isa/link_word.h"

namespace csgsim::division {

/// Widths in bits of the numbers in an encoded display model. Members without a constant value are the minimum for the
/// numbers of the model; the header stores them.
struct Widths {
  static constexpr unsigned count = 32;  ///< number of planes, primitives or nodes
  static constexpr unsigned side = 15;   ///< number of pixels, 0 to 2^14
  static constexpr unsigned bits = 5;    ///< number of bits of depth, fraction, colour, or an index
  static constexpr unsigned width = 6;   ///< a width above 31 bits
  static constexpr unsigned place = 13;  ///< bit position in pixel memory, or its end

  unsigned slope = 1;       ///< width of A and B, two's complement
  unsigned constant = 1;    ///< width of C, two's complement
  unsigned plane = 0;       ///< width of the index of a plane
  unsigned halfspaces = 0;  ///< width of the number of a primitive's half-spaces
  unsigned operands = 0;    ///< width of the number of an operator's operands
  unsigned depth = 0;       ///< width of a depth step or the end of the range: z_bits + 1
  unsigned colour = 0;

  /// Header: counts, picture size, sampling, the widths below, fields, background.
  [[nodiscard]] unsigned header() const { return 3 * count + 2 * side + 5 * bits + 3 * width + 7 * place + 1 + colour; }
  [[nodiscard]] unsigned plane_record() const { return 1 + 2 * slope + constant; }
  /// Excludes the colour at depth 0, which follows only for a primitive that is not complemented.
  [[nodiscard]] unsigned primitive_record() const { return 4 * side + 2 * depth + 2 + halfspaces; }
  /// Excludes the colour, which follows only for a visible half-space.
  [[nodiscard]] unsigned halfspace_record() const { return plane + 1; }
  /// Excludes the operator and the number of its operands, which follow only for an operator.
  static constexpr unsigned node_record = 1;
};

Widths widths_of(const DisplayModel& model);

/// Encodes the stream that the host sends. Throws InputError if the model is invalid.
Bits encode(const DisplayModel& model);

/// Decodes the stream. Throws InputError unless the stream is exactly the output of encode() for some model.
DisplayModel decode(const Bits& bits);

/// Splits the stream into link_words() words of a link of 1 to 256 bits. The last is padded with 0.
std::vector<isa::LinkWord> to_link(const Bits& bits, unsigned link_width);

/// Decodes the words of a whole model. Throws InputError unless they equal to_link() of an encoded model.
DisplayModel from_link(std::span<const isa::LinkWord> words, unsigned link_width);

}  // namespace csgsim::division
