#include "sim/app/memory.h"

#include "hw/base/messages.h"

namespace csgsim::app {

namespace {

/// Bytes a pixel, but for its memory bits.
constexpr std::uint64_t functional_bytes = 28;
constexpr std::uint64_t cycle_bytes = 38;
constexpr std::uint64_t reference_bytes = 16;

constexpr std::uint64_t much = std::uint64_t{1} << 30U;

}  // namespace

std::uint64_t memory_estimate(const machines::Machine& machine, const isa::ArrayShape& picture,
                              std::string_view level) {
  const std::uint64_t pixels = std::uint64_t{picture.width} * picture.height;
  const bool is_whole = machine.array.width >= picture.width && machine.array.height >= picture.height;
  if (level == "functional" || !is_whole) return pixels * functional_bytes;
  return pixels * ((level == "cycle" ? cycle_bytes : reference_bytes) + picture.memory_bits / 8);
}

void announce_memory(const machines::Machine& machine, const isa::ArrayShape& picture, std::string_view level) {
  const std::uint64_t bytes = memory_estimate(machine, picture, level);
  if (bytes < much) return;
  tell_line(fmt::format("{} x {} pixels at the {} level take about {:.1f} GB of memory", picture.width, picture.height,
                        level, static_cast<double>(bytes) / 1e9));
}

}  // namespace csgsim::app
