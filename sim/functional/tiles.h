#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "sim/engine/engine.h"
#include "sim/functional/crew.h"
#include "sim/functional/stretch.h"
#include "sim/functional/tile.h"

namespace csgsim::functional {

/// The pixels of one segment after another, as tiles that any thread can work on, since instructions look at no pixel
/// but their own.
class Tiles final : public engine::PixelState {
 public:
  Tiles(const isa::Program& program, unsigned threads, Decide decide = Decide::by_block);

  /// Memory and enable 0, as a segment begins.
  void begin(const isa::Region& region);

  struct Tally {
    std::vector<std::uint64_t> enabled;  ///< pixels whose E was 1 when each instruction began
    std::uint64_t overflows = 0;         ///< enabled pixels at which the sum did not fit its width
  };

  /// Carries out the instructions at one tile after the other, on all threads, and shows observers the enable bits.
  Tally execute(const Stretch& stretch);

  [[nodiscard]] isa::Region region() const override { return region_; }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override;
  void read_enable(std::span<std::uint64_t> words) const override;

  /// Of one pixel, counted from the region's top left.
  [[nodiscard]] std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] bool enabled(std::uint32_t x, std::uint32_t y) const;

  /// E and every memory bit, as RunState::planes.
  [[nodiscard]] std::vector<std::vector<std::uint64_t>> planes() const;
  /// Memory and enable are 0 before, as begin leaves them.
  void load(std::span<const std::vector<std::uint64_t>> planes);

  /// Of all segments so far.
  [[nodiscard]] engine::Work work() const;

 private:
  [[nodiscard]] std::size_t tiles_a_row() const { return (region_.width + tile_side - 1) / tile_side; }
  /// Of a plane, the first of the tile's words, which are a row of words apart.
  [[nodiscard]] std::size_t first_word(const Tile& tile) const {
    return tile.y() * tiles_a_row() + tile.x() / tile_side;
  }
  [[nodiscard]] const Tile& tile_of(std::uint32_t x, std::uint32_t y) const;

  const isa::Program& program_;
  std::unique_ptr<Crew> crew_;
  Decide decide_;
  isa::Region region_;
  std::vector<Tile> tiles_;  ///< row by row
  engine::Work earlier_;     ///< of tiles that are no more
};

}  // namespace csgsim::functional
