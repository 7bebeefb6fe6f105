#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

// A primitive, a node of the model's file, is drawn as one convex piece or as several. Origins name pieces, which are
// numbered through, primitive after primitive; people are told of primitives.

inline constexpr std::uint32_t most_pieces = 16'000'000;

/// Pieces of all primitives.
std::uint32_t piece_count(const Facts& facts);

/// The primitive that a piece belongs to. A number past the last piece is its own.
std::uint32_t primitive_of(const Facts& facts, std::uint32_t piece);

/// Pieces that follow each other.
struct PieceRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// Those of a primitive that there is.
PieceRange pieces_of(const Facts& facts, std::uint32_t primitive);

/// `p4`, or `p4.2` for the third of several pieces.
std::string piece_label(const Facts& facts, std::uint32_t piece);

/// `p4 cylinder@9:9` or `p4.2 text@9:9`; the label alone where there is no such piece.
std::string piece_name(const Facts& facts, std::uint32_t piece);

/// How many pieces each primitive has; none if each has one.
std::vector<std::uint32_t> piece_counts(const Facts& facts);

/// Says how many pieces each primitive has, one at least.
void set_piece_counts(const std::vector<std::uint32_t>& counts, Facts& facts);

}  // namespace csgsim::isa
