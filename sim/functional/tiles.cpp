#include "sim/functional/tiles.h"

#include <algorithm>
#include <array>
#include <functional>

namespace csgsim::functional {

namespace {

void notify_observers(const Tile& tile, const isa::Region& region, const Stretch& stretch, std::size_t instruction) {
  const TileShape& shape = tile.shape();
  std::array<std::uint64_t, tile_side> rows;
  write_rows(tile.enable(), shape, rows.data(), 1);
  stretch.notify_observers(instruction, {region.x + tile.x(), region.y + tile.y(), shape.width(), shape.height()},
                           std::span(rows).first(shape.height()));
}

void run_tile(Tile& tile, const isa::Region& region, const Stretch& stretch, Tiles::Tally& tally) {
  const std::span enabled(tally.enabled);
  std::uint64_t overflows = 0;
  for (std::size_t i = 0;; ++i) {
    if (tile.enabled() == 0) i = stretch.first_acting_from(i);
    if (i == stretch.size()) break;
    enabled[i] += tile.enabled();
    overflows += tile.execute(stretch.instructions()[i]);
    if (tile.enabled() != 0 && stretch.is_observed(i)) notify_observers(tile, region, stretch, i);
  }
  tally.overflows += overflows;
}

}  // namespace

Tiles::Tiles(const isa::Program& program, unsigned threads, Decide decide)
    : program_(program), crew_(std::make_unique<Crew>(threads)), decide_(decide) {}

void Tiles::begin(const isa::Region& region) {
  const bool fits = !tiles_.empty() && region_.width == region.width && region_.height == region.height;
  if (fits) {
    region_ = region;
    for (Tile& tile : tiles_) tile.clear();
    return;
  }
  earlier_ = work();
  region_ = region;
  tiles_.clear();
  for (std::uint32_t y = 0; y < region.height; y += tile_side)
    for (std::uint32_t x = 0; x < region.width; x += tile_side) {
      const TileShape shape(std::min(tile_side, region.width - x), std::min(tile_side, region.height - y));
      tiles_.emplace_back(x, y, shape, program_.shape.memory_bits, decide_);
    }
}

engine::Work Tiles::work() const {
  engine::Work all = earlier_;
  for (const Tile& tile : tiles_) all += tile.work();
  return all;
}

Tiles::Tally Tiles::execute(const Stretch& stretch) {
  std::vector<Tally> tallies(crew_->threads());
  for (Tally& tally : tallies) tally.enabled.resize(stretch.size());
  crew_->run(tiles_.size(),
             [&](std::size_t tile, unsigned thread) { run_tile(tiles_[tile], region_, stretch, tallies[thread]); });
  Tally all = std::move(tallies.front());
  for (std::size_t thread = 1; thread < tallies.size(); ++thread) {
    all.overflows += tallies[thread].overflows;
    std::transform(all.enabled.begin(), all.enabled.end(), tallies[thread].enabled.begin(), all.enabled.begin(),
                   std::plus<>());
  }
  return all;
}

void Tiles::read_field(isa::Field field, std::span<std::uint32_t> values) const {
  crew_->run(tiles_.size(), [&](std::size_t number, unsigned /*thread*/) {
    const Tile& tile = tiles_[number];
    tile.memory().values(field, values.data() + std::size_t{tile.y()} * region_.width + tile.x(), region_.width);
  });
}

void Tiles::read_enable(std::span<std::uint64_t> words) const {
  for (const Tile& tile : tiles_)
    write_rows(tile.enable(), tile.shape(), words.data() + first_word(tile), tiles_per_row());
}

const Tile& Tiles::tile_at(std::uint32_t x, std::uint32_t y) const {
  return tiles_[y / tile_side * tiles_per_row() + x / tile_side];
}

std::uint32_t Tiles::value(isa::Field field, std::uint32_t x, std::uint32_t y) const {
  return tile_at(x, y).value(field, x % tile_side, y % tile_side);
}

bool Tiles::is_enabled(std::uint32_t x, std::uint32_t y) const {
  return tile_at(x, y).is_enabled(x % tile_side, y % tile_side);
}

std::vector<std::vector<std::uint64_t>> Tiles::planes() const {
  std::vector<std::vector<std::uint64_t>> planes;
  std::vector<std::uint64_t> words(tiles_per_row() * region_.height);
  const auto keep = [&] {
    const bool is_zero = std::all_of(words.begin(), words.end(), [](std::uint64_t word) { return word == 0; });
    planes.push_back(is_zero ? std::vector<std::uint64_t>{} : words);
  };
  read_enable(words);
  keep();
  TileBits copy;
  for (unsigned bit = 0; bit < program_.shape.memory_bits; ++bit) {
    for (const Tile& tile : tiles_)
      write_rows(tile.bit(bit, copy), tile.shape(), words.data() + first_word(tile), tiles_per_row());
    keep();
  }
  return planes;
}

void Tiles::load(std::span<const std::vector<std::uint64_t>> planes) {
  for (Tile& tile : tiles_) {
    for (std::size_t plane = 0; plane < planes.size(); ++plane) {
      if (planes[plane].empty()) continue;
      const std::uint64_t* const rows = planes[plane].data() + first_word(tile);
      if (plane == 0) {
        tile.write_enable(rows, tiles_per_row());
      } else {
        tile.write_bit(static_cast<unsigned>(plane - 1), rows, tiles_per_row());
      }
    }
  }
}

}  // namespace csgsim::functional
