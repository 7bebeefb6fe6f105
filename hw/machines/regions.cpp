#include "hw/machines/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "hw/isa/error.h"

namespace csgsim::machines {

namespace {

std::vector<isa::Region> lines(const Size& picture, bool interlaced) {
  std::vector<isa::Region> all;
  const std::uint32_t step = interlaced ? 2 : 1;
  for (std::uint32_t first = 0; first < step; ++first) {
    for (std::uint32_t y = first; y < picture.height; y += step) all.push_back({0, y, picture.width, 1});
  }
  return all;
}

/// Column and row of a square.
struct Place {
  std::uint32_t column = 0;
  std::uint32_t row = 0;
};

std::vector<Place> by_rows(std::uint32_t columns, std::uint32_t rows, bool serpentine) {
  std::vector<Place> places;
  for (std::uint32_t row = 0; row < rows; ++row) {
    const bool backwards = serpentine && row % 2 == 1;
    for (std::uint32_t i = 0; i < columns; ++i) places.push_back({backwards ? columns - 1 - i : i, row});
  }
  return places;
}

/// Every other bit of the code, from the lowest on.
std::uint32_t even_bits(std::uint64_t code) {
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 32; ++i) bits |= static_cast<std::uint32_t>(code >> (2 * i) & 1U) << i;
  return bits;
}

std::vector<Place> by_morton_codes(std::uint32_t columns, std::uint32_t rows) {
  const std::uint64_t side = std::bit_ceil(std::max(columns, rows));
  std::vector<Place> places;
  for (std::uint64_t code = 0; code < side * side; ++code) {
    const Place place{even_bits(code), even_bits(code >> 1U)};
    if (place.column < columns && place.row < rows) places.push_back(place);
  }
  return places;
}

std::vector<isa::Region> squares(const Size& picture, const isa::ArrayShape& array, SquareOrder order) {
  const std::uint32_t columns = (picture.width + array.width - 1) / array.width;
  const std::uint32_t rows = (picture.height + array.height - 1) / array.height;
  const std::vector<Place> places = order == SquareOrder::morton
                                        ? by_morton_codes(columns, rows)
                                        : by_rows(columns, rows, order == SquareOrder::serpentine);
  std::vector<isa::Region> all;
  for (const Place& place : places) {
    const std::uint32_t x = place.column * array.width;
    const std::uint32_t y = place.row * array.height;
    all.push_back({x, y, std::min(array.width, picture.width - x), std::min(array.height, picture.height - y)});
  }
  return all;
}

void refuse_answers(const isa::Segment& segment, std::size_t number, const Machine& machine) {
  const auto asks =
      std::find_if(segment.instructions.begin(), segment.instructions.end(), [](const isa::Instruction& instruction) {
        return isa::info(instruction.opcode).clock_class == isa::ClockClass::answer;
      });
  if (asks == segment.instructions.end()) return;
  throw InputError(
      fmt::format("segment {}, instruction {}: {} asks for an answer, and no wire of {} brings it back to the host; "
                  "leave it out, or take a machine of the kind {}",
                  number, asks - segment.instructions.begin(), isa::info(asks->opcode).name, machine.name,
                  name_of(Kind::frame_buffer)));
}

}  // namespace

std::vector<isa::Region> regions(const Machine& machine) {
  switch (machine.kind) {
    case Kind::frame_buffer: return {{0, 0, machine.array.width, machine.array.height}};
    case Kind::scan_line: return lines(machine.picture, machine.scan_line.interlaced);
    case Kind::pixel_square: return squares(machine.picture, machine.array, machine.pixel_square.order);
  }
  return {};
}

void check_parts(const isa::Program& program, const Machine& machine) {
  if (machine.kind == Kind::frame_buffer) return;
  if (program.shape.memory_bits > machine.array.memory_bits) {
    throw InputError(fmt::format("the Program is for pixels of {} bits, {} has {}; compile it for this machine",
                                 program.shape.memory_bits, machine.name, machine.array.memory_bits));
  }
  Machine drawing = machine;
  set_picture_size(drawing, {program.shape.width, program.shape.height});
  const std::vector<isa::Region> parts = regions(drawing);
  const bool alike = std::equal(parts.begin(), parts.end(), program.segments.begin(), program.segments.end(),
                                [](const isa::Region& part, const isa::Segment& one) { return part == one.region; });
  if (!alike) {
    throw InputError(
        fmt::format("the Program's segments are not the {} regions in which {} draws a picture of {}x{}; "
                    "compile it for this machine",
                    parts.size(), machine.name, program.shape.width, program.shape.height));
  }
  for (std::size_t s = 0; s < program.segments.size(); ++s) refuse_answers(program.segments[s], s, machine);
}

}  // namespace csgsim::machines
