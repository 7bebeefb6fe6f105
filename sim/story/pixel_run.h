#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/timing.h"

namespace csgsim::story {

/// What one instruction of a segment did at a pixel.
struct PixelStep {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< within the segment
  bool enabled_before = false;
  bool enabled_after = false;
  bool fits = true;           ///< A*x + B*y + C fits the width, or need not
  std::int64_t value = 0;     ///< F at the pixel; 0 without a linear expression
  std::uint64_t met = 0;      ///< what the instruction's first field held before; 0 without one
  std::uint64_t met_too = 0;  ///< the same of the second field
  isa::Field target;          ///< of pixel memory that it may have written; of width 0 if none
  std::uint64_t before = 0;   ///< value of the target
  std::uint64_t after = 0;    ///< the same
  std::uint32_t owner = 0;    ///< primitive that owns the pixel afterwards; observe::no_owner if none does
  bool takes_pixel = false;   ///< it made its primitive the owner
  std::uint64_t skipped = 0;  ///< instructions after it that it leaves out
};

/// A surface that a finished picture shows at a pixel.
struct ShownSurface {
  std::uint32_t owner = 0;  ///< primitive whose it is; observe::no_owner where nothing is seen
  std::uint32_t depth = 0;  ///< steps; all ones where nothing is seen
};

/// A frame as one pixel sees it.
struct PixelRun {
  std::vector<std::uint32_t> segments;  ///< that hold the pixel, in order
  std::vector<PixelStep> steps;         ///< instructions that were carried out, in order
  ShownSurface nearest;
  ShownSurface opaque;       ///< the nearest, or what is seen through that
  std::uint32_t colour = 0;  ///< the same
};

/// Carries out one pixel's part of a Program by the meanings of the instructions, bit by bit (sim/reference): the other
/// pixels matter to it by what a skip_if_none leaves out alone, which `skips` tells. A picture
/// drawn several times, one over the other, has several segments that hold the pixel. Throws InputError where the
/// picture has no such pixel.
///
/// Where a target lies within a field that the Program names, the change is that of the whole field (named_around).
PixelRun run_pixel(const isa::Program& program, std::span<const machines::Skip> skips, std::uint32_t x,
                   std::uint32_t y);

/// What a run of all pixels tells of the Program's clocks (at the functional level). Throws InputError if the machine
/// cannot run it.
machines::RunRecord record_of(const isa::Program& program, const machines::Machine& machine);

/// The smallest field with a name that holds this one, of several the first; the field itself if there is none. Of a
/// depth, whose bits are scratch for effects in between, a part is none.
isa::Field named_around(const isa::Program& program, isa::Field field);

}  // namespace csgsim::story
