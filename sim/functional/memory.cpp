#include "sim/functional/memory.h"

#include <algorithm>

#include "hw/base/quotient.h"
#include "sim/functional/word_kernels.h"

namespace csgsim::sim {

namespace {

std::uint32_t words_for(std::uint32_t pixels) { return quotient_up(pixels, word_bits); }

}  // namespace

Memory::Memory(std::uint32_t width, std::uint32_t height, std::uint32_t bits)
    : width_(width), height_(height), words_per_row_(words_for(width)), planes_(bits), holder_(bits) {}

void Memory::clear() {
  for (const auto& plane : planes_)
    if (plane) plane->clear();
  for (const auto& lanes : lanes_) set_to_zero(*lanes);
}

void Memory::set_to_zero(Lanes& lanes) const {
  const Cells cells(lanes.bounds);
  for (std::uint32_t row = cells.row; row < cells.row + cells.rows; ++row)
    std::fill_n(lanes.values.begin() + static_cast<std::ptrdiff_t>(first_lane(row, cells.column)),
                cells.columns * word_bits, 0);
  lanes.bounds = {};
}

BitPlane& Memory::stored_plane(unsigned bit) {
  if (!planes_[bit]) planes_[bit] = std::make_unique<BitPlane>(width_, height_);
  return *planes_[bit];
}

BitPlane& Memory::plane(unsigned bit) {
  if (Lanes* const holder = holder_[bit]) spill(*holder);
  return stored_plane(bit);
}

const BitPlane& Memory::read(unsigned bit, const Rect& where, BitPlane& copy) const {
  Lanes* const holder = holder_[bit];
  if (holder == nullptr && planes_[bit]) return *planes_[bit];
  copy.clear();
  if (holder == nullptr) return copy;
  const Rect wanted = intersection(where, holder->bounds);
  if (wanted.empty()) return copy;
  copy.cover(wanted);
  gather_bit(copy.block(), at(*holder, wanted), bit - holder->field.base);
  // Whole words were gathered, and the bounds take them all in; those of the pixels past a row's end are 0.
  const Cells cells(wanted);
  copy.narrow(
      {cells.column * word_bits, wanted.y0, std::min(width_, (cells.column + cells.columns) * word_bits), wanted.y1});
  return copy;
}

void Memory::spill(Lanes& lanes) {
  const Rect bounds = lanes.bounds;
  for (unsigned bit = 0; bit < lanes.field.width; ++bit) {
    holder_[lanes.field.base + bit] = nullptr;
    if (bounds.empty()) continue;
    BitPlane& plane = stored_plane(lanes.field.base + bit);
    plane.cover(bounds);
    gather_bit(plane.block(), at(lanes, bounds), bit);
    settle(plane);
  }
  set_to_zero(lanes);
  lanes.field = {};
}

Lanes& Memory::unused_lanes() {
  const auto found =
      std::find_if(lanes_.begin(), lanes_.end(), [](const auto& lanes) { return lanes->field.width == 0; });
  if (found != lanes_.end()) return **found;
  Lanes& lanes = *lanes_.emplace_back(std::make_unique<Lanes>());
  lanes.values.resize(first_lane(height_, 0));
  return lanes;
}

Lanes& Memory::lanes(isa::Field field) {
  if (Lanes* const holder = holder_[field.base]; holder != nullptr && holder->field == field) return *holder;
  for (unsigned bit = field.base; bit < field.end(); ++bit)
    if (Lanes* const holder = holder_[bit]) spill(*holder);
  Lanes& lanes = unused_lanes();
  lanes.field = field;
  for (unsigned bit = 0; bit < field.width; ++bit) {
    holder_[field.base + bit] = &lanes;
    BitPlane* const plane = planes_[field.base + bit].get();
    if (plane == nullptr || plane->bounds().empty()) continue;
    plane->materialise();
    scatter_bit(plane->block(), at(lanes, plane->bounds()), bit);
    lanes.bounds = hull(lanes.bounds, plane->bounds());
    plane->clear();
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

void Memory::values(isa::Field field, std::span<std::uint32_t> out) const {
  if (const Lanes* const holder = holder_[field.base]; holder != nullptr && holder->field == field) {
    for (std::uint32_t row = 0; row < height_; ++row)
      std::copy_n(holder->values.begin() + static_cast<std::ptrdiff_t>(first_lane(row, 0)), width_,
                  out.begin() + static_cast<std::ptrdiff_t>(row) * width_);
    return;
  }
  std::fill_n(out.begin(), static_cast<std::size_t>(width_) * height_, 0);
  BitPlane copy(width_, height_);
  const Rect whole = copy.whole();
  for (unsigned bit = 0; bit < field.width; ++bit) {
    const BitPlane& plane = read(field.base + bit, whole, copy);
    const Cells cells(plane.bounds());
    for (std::uint32_t row = cells.row; row < cells.row + cells.rows; ++row)
      for (std::uint32_t column = cells.column; column < cells.column + cells.columns; ++column)
        for (std::uint64_t word = plane.word(row, column); word != 0; word &= word - 1) {
          const std::size_t x = std::size_t{column} * word_bits + static_cast<std::size_t>(std::countr_zero(word));
          out[static_cast<std::size_t>(row) * width_ + x] |= std::uint32_t{1} << bit;
        }
  }
}

}  // namespace csgsim::sim
