#include "hw/isa/pieces.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/base/text.h"
#include "hw/isa/facts.h"

namespace csgsim::isa {

std::uint32_t piece_count(const Facts& facts) {
  const std::size_t count =
      facts.primitive_of_piece.empty() ? facts.primitives.size() : facts.primitive_of_piece.size();
  return static_cast<std::uint32_t>(count);
}

std::uint32_t primitive_of(const Facts& facts, std::uint32_t piece) {
  return piece < facts.primitive_of_piece.size() ? facts.primitive_of_piece[piece] : piece;
}

PieceRange pieces_of(const Facts& facts, std::uint32_t primitive) {
  if (facts.primitive_of_piece.empty()) return {primitive, 1};
  const auto& all = facts.primitive_of_piece;
  const auto [first, end] = std::equal_range(all.begin(), all.end(), primitive);
  return {static_cast<std::uint32_t>(first - all.begin()), static_cast<std::uint32_t>(end - first)};
}

std::string piece_label(const Facts& facts, std::uint32_t piece) {
  const std::uint32_t primitive = primitive_of(facts, piece);
  const PieceRange range = pieces_of(facts, primitive);
  return range.count > 1 ? fmt::format("p{}.{}", primitive, piece - range.first) : fmt::format("p{}", primitive);
}

std::string piece_name(const Facts& facts, std::uint32_t piece) {
  const std::uint32_t primitive = primitive_of(facts, piece);
  const std::string label = piece_label(facts, piece);
  return primitive < facts.primitives.size() ? label + " " + printable(facts.primitives[primitive]) : label;
}

std::vector<std::uint32_t> piece_counts(const Facts& facts) {
  if (facts.primitive_of_piece.empty()) return {};
  std::vector<std::uint32_t> counts(facts.primitives.size());
  for (const std::uint32_t primitive : facts.primitive_of_piece) ++counts[primitive];
  return counts;
}

void set_piece_counts(const std::vector<std::uint32_t>& counts, Facts& facts) {
  facts.primitive_of_piece.clear();
  if (std::all_of(counts.begin(), counts.end(), [](std::uint32_t count) { return count == 1; })) return;
  for (std::uint32_t i = 0; i < counts.size(); ++i)
    facts.primitive_of_piece.insert(facts.primitive_of_piece.end(), counts[i], i);
}

}  // namespace csgsim::isa
