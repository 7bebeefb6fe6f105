#include "sim/debug/field_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "hw/isa/colour_format.h"
#include "sim/debug/show.h"

namespace csgsim::debug {

namespace {

std::vector<std::uint32_t> values_of(isa::Field field, const engine::Run& run) {
  const isa::Region region = run.region();
  std::vector<std::uint32_t> values(std::size_t{region.width} * region.height);
  if (field.width > 0) {
    run.read_field(field, values);
    return values;
  }
  for (std::uint32_t y = 0; y < region.height; ++y)
    for (std::uint32_t x = 0; x < region.width; ++x)
      values[std::size_t{y} * region.width + x] = run.is_enabled(x, y) ? 1 : 0;
  return values;
}

/// Smallest and largest relevant value.
struct Range {
  std::uint32_t low = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t high = 0;
};

std::uint8_t grey(std::uint32_t value, const Range& range) {
  if (value >= range.high) return 255;
  const std::uint64_t above = value - range.low;
  return static_cast<std::uint8_t>(above * 255 / (range.high - range.low));
}

}  // namespace

FieldPicture draw_field(isa::Field field, const engine::Run& run, const isa::Program& program) {
  const std::vector<std::uint32_t> values = values_of(field, run);
  const FieldMeaning meaning = field_meaning(field, program);
  const std::uint64_t nothing = meaning.is_depth ? (std::uint64_t{1} << field.width) - 1 : std::uint64_t{1} << 32U;
  Range range;
  for (const std::uint32_t value : values) {
    if (value == nothing) continue;
    range = {std::min(range.low, value), std::max(range.high, value)};
  }
  if (field.width <= 1) range = {0, 1};
  range.low = std::min(range.low, range.high);
  FieldPicture drawn{{program.shape.width, program.shape.height, meaning.is_colour ? 3 : 1, {}}, ""};
  const auto channels = static_cast<std::size_t>(drawn.picture.channels);
  drawn.picture.bytes.resize(channels * program.shape.width * program.shape.height);
  const isa::Region region = run.region();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t at = (region.y + i / region.width) * program.shape.width + region.x + i % region.width;
    std::uint8_t* const pixel = &drawn.picture.bytes[channels * at];
    if (meaning.is_colour) {
      std::ranges::copy(isa::unpack_colour(values[i], field.width), pixel);
    } else {
      *pixel = values[i] == nothing ? 255 : grey(values[i], range);
    }
  }
  drawn.scale = meaning.is_colour ? "as colours" : fmt::format("black is {}, white {}", range.low, range.high);
  if (meaning.is_depth) drawn.scale += " or nothing";
  return drawn;
}

}  // namespace csgsim::debug
