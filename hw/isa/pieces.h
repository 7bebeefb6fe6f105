// Maps convex pieces to primitives of the model.
// Used by hw/wave, host/emit and sim.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

// A primitive (a node of the model's file) is drawn as one or more convex pieces. Origins name pieces, which are
// numbered consecutively through all primitives; messages for users name primitives.

inline constexpr std::uint32_t max_pieces = 16'000'000;

/// Number of pieces of all primitives.
std::uint32_t piece_count(const Facts& facts);

/// The primitive of a piece. A number past the last piece is returned unchanged.
std::uint32_t primitive_of(const Facts& facts, std::uint32_t piece);

/// A range of consecutive pieces.
struct PieceRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The pieces of an existing primitive.
PieceRange pieces_of(const Facts& facts, std::uint32_t primitive);

/// `p4`, or `p4.2` for the third of several pieces.
std::string piece_label(const Facts& facts, std::uint32_t piece);

/// `p4 cylinder@9:9` or `p4.2 text@9:9`; the label alone if there is no such piece.
std::string piece_name(const Facts& facts, std::uint32_t piece);

/// Number of pieces of each primitive; empty if each has one.
std::vector<std::uint32_t> piece_counts(const Facts& facts);

/// Sets the number of pieces of each primitive, at least one each.
void set_piece_counts(const std::vector<std::uint32_t>& counts, Facts& facts);

}  // namespace csgsim::isa
