// The pixels of a segment as tiles that several threads process.
// Used by the functional run.
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

/// The pixels of one segment after another, as tiles that any thread can process, since instructions only access their
/// own pixel.
class Tiles final : public engine::PixelState {
 public:
  Tiles(const isa::Program& program, unsigned threads, Decide decide = Decide::by_block);

  /// Clears memory and enable, as at the start of a segment.
  void begin(const isa::Region& region);

  struct Tally {
    std::vector<std::uint64_t> enabled;  ///< number of pixels whose E was 1 when each instruction began
    std::uint64_t overflows = 0;         ///< number of enabled pixels at which an expression exceeded its width
  };

  /// Executes the instructions tile by tile on all threads, and passes the enable bits to observers.
  Tally execute(const Stretch& stretch);

  [[nodiscard]] isa::Region region() const override { return region_; }
  void read_field(isa::Field field, std::span<std::uint32_t> values) const override;
  void read_enable(std::span<std::uint64_t> words) const override;

  /// Value and enable of one pixel, relative to the region's top left.
  [[nodiscard]] std::uint32_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] bool is_enabled(std::uint32_t x, std::uint32_t y) const;

  /// E and every memory bit, in the format of RunState::planes.
  [[nodiscard]] std::vector<std::vector<std::uint64_t>> planes() const;
  /// Sets E and memory, which must be 0 as after begin, from the result of planes().
  void load(std::span<const std::vector<std::uint64_t>> planes);

  /// The work of all segments executed.
  [[nodiscard]] engine::Work work() const;

 private:
  [[nodiscard]] std::size_t tiles_per_row() const { return (region_.width + tile_side - 1) / tile_side; }
  /// Index of the tile's first word in a plane; each further word is one row of words later.
  [[nodiscard]] std::size_t first_word(const Tile& tile) const {
    return tile.y() * tiles_per_row() + tile.x() / tile_side;
  }
  [[nodiscard]] const Tile& tile_at(std::uint32_t x, std::uint32_t y) const;

  const isa::Program& program_;
  std::unique_ptr<Crew> crew_;
  Decide decide_;
  isa::Region region_;
  std::vector<Tile> tiles_;  ///< row by row
  engine::Work earlier_;     ///< work in earlier segments
};

}  // namespace csgsim::functional
