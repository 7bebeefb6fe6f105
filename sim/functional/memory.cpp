#include "sim/functional/memory.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sim/functional/lane_kernels.h"

namespace csgsim::functional {

using isa::Field;

namespace {

constexpr Field one_bit(unsigned bit) { return {static_cast<std::uint16_t>(bit), 1}; }

constexpr bool is_within(Field inner, Field outer) { return inner.base >= outer.base && inner.end() <= outer.end(); }

/// The field of the bits in [first, end); width 0 if that is empty.
constexpr Field bits_between(unsigned first, unsigned end) {
  return {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(end > first ? end - first : 0)};
}

constexpr Field common(Field left, Field right) {
  return bits_between(std::max(left.base, right.base), std::min(left.end(), right.end()));
}

/// Copies a plane; a missing plane is 0.
void copy_plane(const TileBits* plane, TileBits& copy) {
  if (plane == nullptr) {
    copy.clear();
  } else {
    copy.assign(*plane);
  }
}

/// Maximum number of fields that a tile holds as lanes; a Program that draws curved surfaces needs about 20.
constexpr std::size_t max_holders = 24;

void write_values(const Lanes& lanes, const TileShape& shape, std::uint32_t* out, std::size_t stride) {
  for (std::uint32_t y = 0; y < shape.height(); ++y) {
    std::uint32_t* const row = out + y * stride;
    for (std::uint32_t x = 0; x < shape.width(); x += block_side) {
      const std::uint32_t count = std::min(block_side, shape.width() - x);
      const unsigned block = block_of(x, y);
      if (lanes.is_constant(block)) {
        std::fill_n(row + x, count, lanes.least[block]);
      } else {
        std::copy_n(lanes.block(block) + bit_of(0, y), count, row + x);
      }
    }
  }
}

}  // namespace

Memory::Memory(TileShape shape, std::uint32_t bits) : shape_(shape), planes_(bits), holder_counts_(bits) {}

void Memory::clear() {
  for (const auto& plane : planes_)
    if (plane) plane->clear();
  for (const Holder& holder : holders_) {
    holder.lanes->least.fill(0);
    holder.lanes->greatest.fill(0);
  }
}

TileBits& Memory::stored_plane(unsigned bit) {
  if (!planes_[bit]) planes_[bit] = std::make_unique_for_overwrite<TileBits>();
  return *planes_[bit];
}

TileBits& Memory::plane(unsigned bit, std::uint64_t blocks) {
  if (holder_counts_[bit] != 0)
    for (Holder& holder : holders_)
      if (holder.field.overlaps(one_bit(bit))) spill(holder, blocks);
  return stored_plane(bit);
}

const TileBits& Memory::read(unsigned bit, std::uint64_t blocks, TileBits& copy) const {
  const TileBits* const plane = planes_[bit].get();
  if (holder_counts_[bit] == 0 && plane != nullptr) return *plane;
  bool is_copied = false;
  for (const Holder& holder : holders_) {
    const std::uint64_t held = holder.blocks & blocks;
    if (held == 0 || !holder.field.overlaps(one_bit(bit))) continue;
    if (!std::exchange(is_copied, true)) copy_plane(plane, copy);
    TileBits* const planes = &copy;
    gather_planes(*holder.lanes, shape_, held, bit - holder.field.base, {&planes, 1});
  }
  if (is_copied) return copy;
  if (plane != nullptr) return *plane;
  copy.clear();
  return copy;
}

void Memory::planes(Field field, const TargetBlocks& target, std::span<TileBits*> planes) {
  for (Holder& holder : holders_) {
    if (!holder.field.overlaps(field)) continue;
    if (is_within(holder.field, field)) holder.blocks &= ~target.overwritten;
    spill(holder, target.blocks);
  }
  for (unsigned bit = 0; bit < field.width; ++bit) planes[bit] = &stored_plane(field.base + bit);
}

void Memory::write_planes(const Holder& holder, Field field, std::uint64_t blocks) {
  std::array<TileBits*, isa::max_field_width> planes{};
  for (unsigned bit = 0; bit < field.width; ++bit) planes[bit] = &stored_plane(field.base + bit);
  gather_planes(*holder.lanes, shape_, blocks, field.base - holder.field.base, std::span(planes).first(field.width));
}

void Memory::spill(Holder& holder, std::uint64_t blocks) {
  const std::uint64_t spilt = holder.blocks & blocks;
  if (spilt == 0) return;
  write_planes(holder, holder.field, spilt);
  holder.blocks &= ~spilt;
}

Memory::Holder& Memory::holder_for(Field field) {
  const auto known = std::ranges::find(holders_, field, &Holder::field);
  if (known != holders_.end()) return *known;
  const auto unused = std::ranges::find(holders_, std::uint64_t{0}, &Holder::blocks);
  Holder& holder = unused != holders_.end() ? *unused : holders_.size() < max_holders ? add_holder() : reused_holder();
  set_field(holder, field);
  return holder;
}

void Memory::set_field(Holder& holder, Field field) {
  for (unsigned bit = holder.field.base; bit < holder.field.end(); ++bit) --holder_counts_[bit];
  for (unsigned bit = field.base; bit < field.end(); ++bit) ++holder_counts_[bit];
  holder.field = holder.lanes->field = field;
}

Memory::Holder& Memory::add_holder() {
  holders_.push_back({{}, 0, std::make_unique_for_overwrite<Lanes>()});
  holders_.back().lanes->least.fill(0);
  holders_.back().lanes->greatest.fill(0);
  return holders_.back();
}

Memory::Holder& Memory::reused_holder() {
  if (++next_reused_ == max_holders) next_reused_ = 0;
  if (holders_[next_reused_].lanes.get() == last_) return reused_holder();
  spill(holders_[next_reused_], all_blocks);
  return holders_[next_reused_];
}

std::uint64_t Memory::uniform_blocks(Field field) const {
  std::uint64_t blocks = all_blocks;
  for (const Holder& holder : holders_)
    if (holder.field.overlaps(field)) blocks &= ~holder.blocks;
  for (unsigned bit = field.base; bit < field.end(); ++bit)
    if (planes_[bit]) blocks &= ~planes_[bit]->mixed();
  return blocks;
}

void Memory::move(Holder& from, Holder& to, std::uint64_t blocks, std::uint64_t kept) {
  const Field part = common(from.field, to.field);
  if (const Field below = bits_between(from.field.base, part.base); below.width > 0) write_planes(from, below, blocks);
  if (const Field above = bits_between(part.end(), from.field.end()); above.width > 0)
    write_planes(from, above, blocks);
  merge_lanes(*from.lanes, part, kept, *to.lanes);
  from.blocks &= ~blocks;
}

void Memory::convert_to_lanes(Holder& holder, const TargetBlocks& target) {
  const Field field = holder.field;
  const std::uint64_t taken = (target.blocks & ~holder.blocks) | uniform_blocks(field);
  const std::uint64_t kept = taken & ~target.overwritten;
  std::array<const TileBits*, isa::max_field_width> planes{};
  for (unsigned bit = 0; bit < field.width; ++bit) planes[bit] = planes_[field.base + bit].get();
  scatter_planes(std::span(planes).first(field.width), shape_, kept, *holder.lanes);
  each_bit(taken & ~kept, [&](unsigned block) { holder.lanes->set_constant(block, 0); });
  for (Holder& other : holders_) {
    if (&other == &holder || !other.field.overlaps(field)) continue;
    if (const std::uint64_t moved = other.blocks & taken; moved != 0) move(other, holder, moved, moved & kept);
  }
  holder.blocks |= taken;
  for (unsigned bit = field.base; bit < field.end(); ++bit)
    if (planes_[bit]) planes_[bit]->clear_blocks(taken);
}

Lanes& Memory::lanes(Field field, const TargetBlocks& target) {
  Holder& holder = holder_for(field);
  if ((target.blocks & ~holder.blocks) != 0) convert_to_lanes(holder, target);
  last_ = holder.lanes.get();
  return *last_;
}

std::vector<Field> Memory::parts(Field field, std::uint64_t blocks) const {
  std::vector<Field> parts;
  for (unsigned bit = field.base; bit < field.end(); bit = parts.back().end()) {
    const auto part = std::ranges::find_if(holders_, [&](const Holder& holder) {
      return holder.field.base == bit && holder.field.end() <= field.end() && (blocks & ~holder.blocks) == 0;
    });
    if (part == holders_.end()) return {};
    parts.push_back(part->field);
  }
  if (parts.size() < 2) parts.clear();
  return parts;
}

bool Memory::is_in_lanes(Field field, std::uint64_t blocks) const {
  return std::ranges::any_of(
      holders_, [&](const Holder& holder) { return holder.field == field && (blocks & ~holder.blocks) == 0; });
}

bool Memory::is_in_planes(Field field, std::uint64_t blocks) const {
  return std::ranges::none_of(
      holders_, [&](const Holder& holder) { return (holder.blocks & blocks) != 0 && holder.field.overlaps(field); });
}

void Memory::values(Field field, std::uint32_t* out, std::size_t stride) const {
  for (const Holder& holder : holders_)
    if (holder.field == field && (shape_.blocks() & ~holder.blocks) == 0)
      return write_values(*holder.lanes, shape_, out, stride);
  std::array<TileBits, isa::max_field_width> copies;
  std::array<const TileBits*, isa::max_field_width> planes{};
  for (unsigned bit = 0; bit < field.width; ++bit) planes[bit] = &read(field.base + bit, shape_.blocks(), copies[bit]);
  Lanes lanes;
  scatter_planes(std::span(planes).first(field.width), shape_, all_blocks, lanes);
  write_values(lanes, shape_, out, stride);
}

std::uint32_t Memory::value(Field field, std::uint32_t x, std::uint32_t y) const {
  const unsigned block = block_of(x, y);
  const unsigned pixel = bit_of(x, y);
  std::uint32_t value = 0;
  for (unsigned bit = 0; bit < field.width; ++bit) {
    const unsigned at = field.base + bit;
    if (planes_[at]) value |= static_cast<std::uint32_t>(planes_[at]->word(block, shape_) >> pixel & 1U) << bit;
  }
  for (const Holder& holder : holders_) {
    if ((holder.blocks >> block & 1U) == 0) continue;
    for (unsigned bit = 0; bit < field.width; ++bit) {
      const unsigned at = field.base + bit;
      if (holder.field.overlaps(one_bit(at)))
        value |= (holder.lanes->value(block, pixel) >> (at - holder.field.base) & 1U) << bit;
    }
  }
  return value;
}

}  // namespace csgsim::functional
