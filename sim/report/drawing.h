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
  std::uint64_t number = 0;   ///< of instructions of the Program that come before it
  std::string text;           ///< of the last of these; empty before the first
  std::string serves;         ///< whom that serves: a purpose, and pieces of primitives
  std::uint64_t clocks = 0;   ///< of the instructions so far, in all regions
  std::uint64_t enabled = 0;  ///< pixels whose E is 1, of those that are shown
  /// How pixels differ from the step before: runs of varints (codec.h), each how many pixels stay as they are, how many
  /// change, and the exclusive or of their states. A state is the colour in 24 bits, red the highest, times 2, plus E.
  std::string changes;
};

/// Why a pixel shows what it shows.
struct PixelStory {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t primitive = 0;         ///< that is seen there; observe::no_owner if none is
  std::vector<story::TextPart> parts;  ///< the text of csgsim explain
};

/// How a picture comes to be in pixel memory.
struct Drawing {
  std::uint32_t width = 0;   ///< pixels that are shown
  std::uint32_t height = 0;  ///< pixels that are shown
  std::uint32_t every = 1;   ///< pixel of a row, and row, is shown
  std::string told;          ///< in a sentence or two: at which boundaries there are steps, and why no more
  std::vector<DrawingStep> steps;
  std::vector<PixelStory> stories;
  std::string explain;  ///< Context::explain
};

struct DrawingLimits {
  std::uint64_t instructions = 2000;  ///< a step each in Programs that are no longer
  std::size_t steps = 2000;
  std::size_t bytes = 700'000;  ///< of all steps, in the page
  std::uint32_t side = 512;     ///< pixels shown in a row and in a column
};

/// Whom an instruction serves: its purpose, and pieces of primitives.
std::string served_by(const isa::Instruction& instruction, const isa::Facts& facts);

/// Runs the Program at the functional level and takes down what it draws. Where steps fill more than the limits allow,
/// every second is left out until they do not, and `told` tells it. The first step and the last stay, whatever they
/// fill. There are no stories yet (stories.h).
Drawing record_drawing(const isa::Program& program, const machines::Machine& machine, const DrawingLimits& limits = {});

/// The number of the first step after at least that many instructions; of the last step if there is none.
std::size_t step_after(std::span<const DrawingStep> steps, std::uint64_t instructions);

}  // namespace csgsim::report
