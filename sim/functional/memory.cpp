#include "sim/functional/memory.h"

#include <algorithm>
#include <array>

#include "sim/functional/lane_kernels.h"

namespace csgsim::functional {

namespace {

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

Memory::Memory(TileShape shape, std::uint32_t bits) : shape_(shape), planes_(bits), holder_(bits) {}

void Memory::clear() {
  for (const auto& plane : planes_)
    if (plane) plane->clear();
  for (const auto& lanes : lanes_) {
    lanes->least.fill(0);
    lanes->greatest.fill(0);
  }
}

TileBits& Memory::stored_plane(unsigned bit) {
  if (!planes_[bit]) planes_[bit] = std::make_unique<TileBits>();
  return *planes_[bit];
}

TileBits& Memory::plane(unsigned bit) {
  if (Lanes* const holder = holder_[bit]) spill(*holder);
  return stored_plane(bit);
}

const TileBits& Memory::read(unsigned bit, std::uint64_t blocks, TileBits& copy) const {
  const Lanes* const holder = holder_[bit];
  if (holder == nullptr && planes_[bit]) return *planes_[bit];
  copy.clear();
  TileBits* const planes = &copy;
  if (holder != nullptr) gather_planes(*holder, shape_, blocks, bit - holder->field.base, {&planes, 1});
  return copy;
}

void Memory::spill(Lanes& lanes) {
  std::array<TileBits*, isa::max_field_width> planes{};
  for (unsigned bit = 0; bit < lanes.field.width; ++bit) {
    holder_[lanes.field.base + bit] = nullptr;
    planes[bit] = &stored_plane(lanes.field.base + bit);
  }
  gather_planes(lanes, shape_, shape_.blocks(), 0, std::span(planes).first(lanes.field.width));
  lanes.field = {};
}

Lanes& Memory::unused_lanes() {
  const auto found =
      std::find_if(lanes_.begin(), lanes_.end(), [](const auto& lanes) { return lanes->field.width == 0; });
  return found != lanes_.end() ? **found : *lanes_.emplace_back(std::make_unique_for_overwrite<Lanes>());
}

Lanes& Memory::lanes(isa::Field field) {
  if (in_lanes(field)) return *holder_[field.base];
  for (unsigned bit = field.base; bit < field.end(); ++bit)
    if (Lanes* const holder = holder_[bit]) spill(*holder);
  Lanes& lanes = unused_lanes();
  lanes.field = field;
  std::array<const TileBits*, isa::max_field_width> planes{};
  for (unsigned bit = 0; bit < field.width; ++bit) planes[bit] = planes_[field.base + bit].get();
  scatter_planes(std::span(planes).first(field.width), shape_, lanes);
  for (unsigned bit = field.base; bit < field.end(); ++bit) {
    holder_[bit] = &lanes;
    if (planes_[bit]) planes_[bit]->clear();
  }
  return lanes;
}

std::vector<isa::Field> Memory::parts(isa::Field field) const {
  std::vector<isa::Field> parts;
  for (unsigned bit = field.base; bit < field.end(); bit = parts.back().end()) {
    const Lanes* const holder = holder_[bit];
    if (holder == nullptr || holder->field.base != bit || holder->field.end() > field.end()) return {};
    parts.push_back(holder->field);
  }
  if (parts.size() < 2) parts.clear();
  return parts;
}

bool Memory::in_planes(isa::Field field) const {
  const auto first = holder_.begin() + field.base;
  return std::all_of(first, first + field.width, [](const Lanes* holder) { return holder == nullptr; });
}

void Memory::values(isa::Field field, std::uint32_t* out, std::size_t stride) const {
  if (in_lanes(field)) return write_values(*holder_[field.base], shape_, out, stride);
  std::array<TileBits, isa::max_field_width> copies;
  std::array<const TileBits*, isa::max_field_width> planes{};
  for (unsigned bit = 0; bit < field.width; ++bit) planes[bit] = &read(field.base + bit, shape_.blocks(), copies[bit]);
  Lanes lanes;
  scatter_planes(std::span(planes).first(field.width), shape_, lanes);
  write_values(lanes, shape_, out, stride);
}

std::uint32_t Memory::value(isa::Field field, std::uint32_t x, std::uint32_t y) const {
  const unsigned block = block_of(x, y);
  const unsigned pixel = bit_of(x, y);
  std::uint32_t value = 0;
  for (unsigned bit = 0; bit < field.width; ++bit) {
    const unsigned at = field.base + bit;
    std::uint64_t one = 0;
    if (const Lanes* const holder = holder_[at]; holder != nullptr) {
      one = holder->value(block, pixel) >> (at - holder->field.base);
    } else if (planes_[at]) {
      one = planes_[at]->word(block, shape_) >> pixel;
    }
    value |= static_cast<std::uint32_t>(one & 1U) << bit;
  }
  return value;
}

}  // namespace csgsim::functional
