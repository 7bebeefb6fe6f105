#include "hw/pixel_square/renderer_taps.h"

#include <optional>
#include <utility>

#include "hw/isa/instruction_numbers.h"
#include "hw/pixel_planes/taps.h"
#include "hw/wave/instruction_taps.h"
#include "hw/wave/pixel_taps.h"
#include "hw/wave/segments.h"

namespace csgsim::pixel_square {

namespace {

using wave::Number;
using wave::Tap;

/// Returns a function that reads the number of the instruction at the pixels; with `segment`, only if it is an
/// instruction of that segment.
std::function<Number()> at_pixels(const RendererParts& parts, const isa::Program& program,
                                  std::optional<std::uint32_t> segment) {
  return [parts, segment, firsts = isa::first_instruction_numbers(program)]() -> Number {
    const std::optional<std::uint32_t> drawn = parts.completion.segment();
    const pixel_planes::ControlWord& word = parts.pipeline.now().at_pixels();
    if (!drawn || !word.steps || (segment && *segment != *drawn)) return std::nullopt;
    return firsts[*drawn] + word.ordinal;
  };
}

}  // namespace

/// Returns false while memory is being cleared, because part of it still holds the previous square.
bool holds_segment(const RendererParts& parts, std::uint32_t segment) {
  const pixel_planes::ControlWord& before = parts.pipeline.now().last_executed();
  return parts.completion.segment() == segment && !(before.clears && !before.last);
}

std::vector<Tap> renderer_taps(const std::string& part, const RendererParts& parts, const isa::Program& program,
                               const systemc::SegmentNames& names) {
  const auto segment = [parts, &names]() -> std::optional<std::uint32_t> {
    const std::optional<isa::Region> square = parts.controller.square();
    return square ? std::optional(names.segment_of(*square)) : std::nullopt;
  };
  std::vector<Tap> taps{wave::text(part + ".state", [parts] { return std::string(parts.controller.state()); }),
                        wave::text(part + ".square", [segment, &program] {
                          const std::optional<std::uint32_t> number = segment();
                          return number ? wave::corner_text(program.segments[*number]) : std::string();
                        })};
  wave::add(wave::instruction_taps(part + ".controller", program,
                                   [parts, segment, firsts = isa::first_instruction_numbers(program)]() -> Number {
                                     const pixel_planes::ControlWord& word = parts.pipeline.now().control();
                                     const std::optional<std::uint32_t> number = word.steps ? segment() : std::nullopt;
                                     return number ? Number(firsts[*number] + word.ordinal) : std::nullopt;
                                   }),
            taps);
  wave::add(pixel_planes::root_taps(part + ".root", parts.pipeline, parts.trees), taps);
  wave::add(pixel_planes::control_taps(part + ".pixels", parts.pipeline, parts.trees.bits, program,
                                       at_pixels(parts, program, std::nullopt)),
            taps);
  return taps;
}

std::vector<Tap> pixel_taps(wave::Pixel pixel, std::uint32_t segment, const RendererParts& parts,
                            const isa::Program& program, std::span<const wave::TreeLevel> levels, unsigned alu_bits) {
  const isa::Region& region = program.segments[segment].region;
  const array::Place place{pixel.x - region.x, pixel.y - region.y};
  const auto shows = [parts, segment] { return holds_segment(parts, segment); };
  std::vector<Tap> taps =
      wave::instruction_taps(wave::pixel_part_name(pixel), program, at_pixels(parts, program, segment));
  wave::add(
      pixel_planes::pixel_taps(pixel, {parts.pipeline, place, place, shows, parts.trees}, program, levels, alu_bits),
      taps);
  return taps;
}

}  // namespace csgsim::pixel_square
