#include "sim/session/run/memory.h"

#include <algorithm>

#include "hw/base/messages.h"
#include "hw/isa/facts.h"

namespace csgsim::session {

namespace {

/// Bytes per pixel, not counting its memory bits.
constexpr std::uint64_t functional_bytes = 28;
constexpr std::uint64_t cycle_bytes = 38;
constexpr std::uint64_t reference_bytes = 12;
/// Word size of a pixel's memory at the reference level, which allocates one word more than it fills.
constexpr std::uint64_t word_bits = 64;

constexpr std::uint64_t announced = std::uint64_t{1} << 30U;

constexpr std::string_view fix = "use fewer half-spaces ($fn, --tolerance), or free more memory";

}  // namespace

std::string out_of_memory_message(const std::string& model, std::size_t halfspaces) {
  return fmt::format("there is not enough memory to compile the {} half-spaces of {}; {}", halfspaces, model, fix);
}

std::string out_of_memory_message(std::span<const isa::Program> programs, const isa::ArrayShape& array) {
  std::uint64_t instructions = 0;
  std::uint64_t halfspaces = 0;
  for (const isa::Program& program : programs) {
    instructions += isa::total_instructions(program);
    halfspaces = std::max(halfspaces, program.facts->model.halfspaces);
  }
  const std::uint64_t pixels = std::uint64_t{array.width} * array.height;
  if (instructions * sizeof(isa::Instruction) <= pixels * (functional_bytes + array.memory_bits / 8)) {
    return fmt::format("there is not enough memory for a picture of {} x {} pixels of {} bits; take a smaller one",
                       array.width, array.height, array.memory_bits);
  }
  return fmt::format("there is not enough memory for a run of {} instructions, made of {} half-spaces; {}",
                     instructions, halfspaces, fix);
}

std::uint64_t memory_estimate(const machines::Machine& machine, const isa::ArrayShape& picture,
                              std::string_view level) {
  const std::uint64_t pixels = std::uint64_t{picture.width} * picture.height;
  const bool is_whole = machine.array.width >= picture.width && machine.array.height >= picture.height;
  if (level == "functional" || !is_whole) return pixels * functional_bytes;
  if (level == "reference") return pixels * (reference_bytes + (picture.memory_bits / word_bits + 1) * word_bits / 8);
  return pixels * (cycle_bytes + picture.memory_bits / 8);
}

void announce_memory(const machines::Machine& machine, const isa::ArrayShape& picture, std::string_view level) {
  const std::uint64_t bytes = memory_estimate(machine, picture, level);
  if (bytes < announced) return;
  report_line(fmt::format("{} x {} pixels at the {} level take about {:.1f} GB of memory", picture.width,
                          picture.height, level, static_cast<double>(bytes) / 1e9));
}

}  // namespace csgsim::session
