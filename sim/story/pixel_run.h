// Executes a Program at a single pixel.
// Used by events.h and story.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/timing.h"

namespace csgsim::story {

/// The action of one instruction of a segment at a pixel.
struct PixelStep {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< within the segment
  bool enabled_before = false;
  bool enabled_after = false;
  bool fits = true;                  ///< A*x + B*y + C fits the width, or may be cut
  std::int64_t value = 0;            ///< F at the pixel; 0 without a linear expression
  std::uint64_t first_operand = 0;   ///< value of the instruction's first field before it; 0 without one
  std::uint64_t second_operand = 0;  ///< value of the instruction's second field before it; 0 without one
  isa::Field target;                 ///< field of pixel memory that it may write; of width 0 if none
  std::uint64_t before = 0;          ///< value of the target before
  std::uint64_t after = 0;           ///< value of the target after
  std::uint32_t owner = 0;           ///< primitive that owns the pixel afterwards; observe::no_owner if none
  bool takes_pixel = false;          ///< the instruction made its primitive the owner
  std::uint64_t skipped = 0;         ///< number of following instructions that it skips
};

/// A visible surface of a finished picture at a pixel.
struct ShownSurface {
  std::uint32_t owner = 0;  ///< visible primitive; observe::no_owner if none
  std::uint32_t depth = 0;  ///< steps; all ones if nothing is visible
};

/// The part of a frame's run that concerns one pixel, and its result.
struct PixelRun {
  std::vector<std::uint32_t> segments;  ///< segments that contain the pixel, in order
  std::vector<PixelStep> steps;         ///< executed instructions, in order
  ShownSurface nearest;
  ShownSurface opaque;       ///< the nearest opaque surface, possibly that of `nearest`
  std::uint32_t colour = 0;  ///< colour as the colour field holds it
};

/// Executes one pixel's part of a Program bit by bit (sim/reference). `skips` lists the skips of the whole run, the
/// only effect of other pixels. A picture drawn several times, one over the other, has several segments that contain
/// the pixel. Throws InputError if the picture has no such pixel.
///
/// If a target lies within a named field of the Program, the change is reported for the whole field
/// (enclosing_named_field).
PixelRun run_pixel(const isa::Program& program, std::span<const machines::Skip> skips, std::uint32_t x,
                   std::uint32_t y);

/// The smallest named field that contains this field (the first of several), or else the field itself. A part of a
/// depth field does not count as contained, since effects use the bits of depth fields for intermediate values.
isa::Field enclosing_named_field(const isa::Program& program, isa::Field field);

}  // namespace csgsim::story
