// Records the evolution of a picture, step by step.
// Used by sim/report and sim/viewer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/story/story_text.h"

namespace csgsim::report {

/// An instruction boundary of a run.
struct DrawingStep {
  std::uint64_t number = 0;   ///< number of instructions of the Program before it
  std::string text;           ///< text of the last of these; empty before the first
  std::string serves;         ///< purpose of that instruction, and pieces of primitives
  std::uint64_t clocks = 0;   ///< clocks of the instructions until here, in all regions
  std::uint64_t enabled = 0;  ///< displayed pixels whose E is 1
  /// Differences from the previous step: runs of varints (codec.h), each the number of unchanged pixels, the number of
  /// changed pixels, and the exclusive or of their states. A state is the colour in 24 bits, red highest, times 2, plus
  /// E.
  std::string changes;
};

/// The history of a pixel, for the page.
struct PixelStory {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t primitive = 0;         ///< visible primitive; observe::no_owner if none
  std::vector<story::TextPart> parts;  ///< text of csgsim explain
};

/// Evolution of a picture in pixel memory.
struct Drawing {
  std::uint32_t width = 0;   ///< displayed pixels
  std::uint32_t height = 0;  ///< displayed pixels
  std::uint32_t every = 1;   ///< one pixel in `every`, and one row in `every`, is displayed
  std::string summary;       ///< one or two sentences on the choice of steps
  std::vector<DrawingStep> steps;
  std::vector<PixelStory> stories;
  std::string explain;  ///< Context::explain
};

struct DrawingLimits {
  std::uint64_t instructions = 2000;  ///< longest Program with a step after each instruction
  std::size_t steps = 2000;
  std::size_t bytes = 700'000;  ///< size of all steps in the page
  std::uint32_t side = 512;     ///< displayed pixels per row and per column
};

/// Text of the purpose of an instruction, and of the pieces of primitives for which it works.
std::string purpose_text(const isa::Instruction& instruction, const isa::Facts& facts);

/// Runs the Program at the functional level and records what it draws. If the steps exceed the limits, every second one
/// is removed until they do not, and `summary` mentions it. The first and the last step always stay. The result
/// has no stories; add_stories() adds them.
Drawing record_drawing(const isa::Program& program, const machines::Machine& machine, const DrawingLimits& limits = {});

/// Index of the first step after at least this number of instructions; of the last step if there is none.
std::size_t step_after(std::span<const DrawingStep> steps, std::uint64_t instructions);

}  // namespace csgsim::report
