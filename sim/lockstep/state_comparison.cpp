#include "sim/lockstep/state_comparison.h"

#include <algorithm>
#include <bit>

#include "hw/isa/facts.h"
#include "hw/isa/operands.h"
#include "hw/isa/text.h"

namespace csgsim::lockstep {

namespace {

constexpr std::uint32_t word_bits = 64;

std::size_t row_words(const isa::Region& region) { return (region.width + word_bits - 1) / word_bits; }

bool bit_at(const std::vector<std::uint64_t>& words, const isa::Region& region, std::size_t pixel) {
  const std::size_t x = pixel % region.width;
  return (words[pixel / region.width * row_words(region) + x / word_bits] >> (x % word_bits) & 1U) != 0;
}

}  // namespace

StateComparison::StateComparison(const isa::Program& names, std::uint32_t memory_bits) {
  std::vector<bool> covered(memory_bits);
  for (const isa::NamedField& named : names.facts->fields) {
    if (named.field.end() > memory_bits) continue;
    parts_.push_back({named.name, named.field});
    std::fill_n(covered.begin() + named.field.base, named.field.width, true);
  }
  for (unsigned bit = 0; bit < memory_bits; ++bit) {
    unsigned end = bit;
    while (end < memory_bits && !covered[end] && end - bit < isa::max_field_width) ++end;
    if (end == bit) continue;
    const isa::Field field{static_cast<std::uint16_t>(bit), static_cast<std::uint16_t>(end - bit)};
    parts_.push_back({isa::text_of(field), field});
    bit = end - 1;
  }
}

std::optional<PixelDifference> StateComparison::compare_all(const engine::PixelState& a, const engine::PixelState& b) {
  std::vector<const Part*> all;
  all.reserve(parts_.size());
  for (const Part& part : parts_) all.push_back(&part);
  return compare(all, a, b);
}

std::optional<PixelDifference> StateComparison::compare_written(const isa::Instruction& instruction,
                                                                const engine::PixelState& a,
                                                                const engine::PixelState& b) {
  std::vector<const Part*> touched;
  for (const Part& part : parts_)
    if (isa::may_write(instruction, part.field)) touched.push_back(&part);
  return compare(touched, a, b);
}

void StateComparison::read(const Part& part, const engine::PixelState& a, const engine::PixelState& b) {
  a_values_.resize(differs_.size());
  b_values_.resize(differs_.size());
  a.read_field(part.field, a_values_);
  b.read_field(part.field, b_values_);
}

void StateComparison::compare_enable(const engine::PixelState& a, const engine::PixelState& b) {
  const isa::Region region = a.region();
  a_enable_.assign(row_words(region) * region.height, 0);
  b_enable_.assign(a_enable_.size(), 0);
  a.read_enable(a_enable_);
  b.read_enable(b_enable_);
  if (a_enable_ == b_enable_) return;
  for (std::size_t pixel = 0; pixel < differs_.size(); ++pixel)
    if (bit_at(a_enable_, region, pixel) != bit_at(b_enable_, region, pixel)) differs_[pixel] = true;
}

void StateComparison::compare_part(const Part& part, const engine::PixelState& a, const engine::PixelState& b) {
  read(part, a, b);
  if (a_values_ == b_values_) return;
  for (std::size_t pixel = 0; pixel < differs_.size(); ++pixel)
    if (a_values_[pixel] != b_values_[pixel]) differs_[pixel] = true;
}

std::optional<PixelDifference> StateComparison::compare(const std::vector<const Part*>& parts,
                                                        const engine::PixelState& a, const engine::PixelState& b) {
  const isa::Region region = a.region();
  differs_.assign(std::size_t{region.width} * region.height, false);
  compare_enable(a, b);
  for (const Part* part : parts) compare_part(*part, a, b);
  const auto first = std::find(differs_.begin(), differs_.end(), true);
  if (first == differs_.end()) return std::nullopt;
  const auto pixel = static_cast<std::size_t>(first - differs_.begin());
  PixelDifference difference{region.x + static_cast<std::uint32_t>(pixel % region.width),
                             region.y + static_cast<std::uint32_t>(pixel / region.width),
                             {},
                             static_cast<std::uint64_t>(std::count(first, differs_.end(), true))};
  const auto keep = [&](const std::string& name, std::uint32_t in_a, std::uint32_t in_b) {
    if (in_a != in_b) difference.fields.push_back({name, in_a, in_b});
  };
  keep("E", bit_at(a_enable_, region, pixel), bit_at(b_enable_, region, pixel));
  for (const Part* part : parts) {
    read(*part, a, b);
    keep(part->name, a_values_[pixel], b_values_[pixel]);
  }
  return difference;
}

}  // namespace csgsim::lockstep
