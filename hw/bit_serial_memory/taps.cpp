#include "hw/bit_serial_memory/taps.h"

#include <string>

#include "hw/base/error.h"
#include "hw/wave/instruction_taps.h"
#include "hw/wave/pixel_taps.h"

namespace csgsim::bit_serial_memory {

namespace {

using wave::Number;
using wave::Tap;

/// A pixel shows no values before its memory has been cleared.
std::vector<Tap> pixel_taps(const TappedParts& parts, const isa::Program& program, wave::Pixel pixel) {
  const std::uint64_t number = std::uint64_t{pixel.y} * parts.picture_width + pixel.x;
  const std::string part = wave::pixel_part_name(pixel);
  const MemoryView& pixels = parts.pixels;
  const Controller& controller = parts.controller;
  std::vector<Tap> taps = wave::instruction_taps(part, program, [&controller] { return Number(controller.ordinal()); });
  taps.push_back(wave::bit(part + ".enable", [&pixels, &controller, number]() -> Number {
    return controller.cleared() ? Number(pixels.enabled(number) ? 1 : 0) : std::nullopt;
  }));
  const auto field = [&pixels, &controller, number](isa::Field at) -> Number {
    if (!controller.cleared()) return std::nullopt;
    std::uint64_t value = 0;
    for (unsigned bit = 0; bit < at.width; ++bit)
      value |= std::uint64_t{pixels.bit(static_cast<Row>(at.base + bit), number)} << bit;
    return value;
  };
  wave::add(wave::field_taps(part, program, field), taps);
  return taps;
}

}  // namespace

std::vector<Tap> machine_taps(const TappedParts& parts, const isa::Program& program, const wave::Request& request) {
  if (!request.tree_levels.empty())
    throw InputError("waves of a bit-serial memory show no tree levels; omit the tree levels");
  const Controller& controller = parts.controller;
  const HostLink& host = parts.host;
  std::vector<Tap> taps{wave::text("host.state", [&host] { return std::string(host.state()); }),
                        wave::text("controller.state", [&controller] { return std::string(controller.state()); }),
                        wave::text("controller.row_command", [&controller] { return controller.row_command(); })};
  wave::add(wave::instruction_taps("controller", program, [&controller] { return Number(controller.ordinal()); }),
            taps);
  for (std::size_t i = 0; i < parts.banks.size(); ++i) {
    const Bank& bank = *parts.banks[i];
    taps.push_back(wave::bit("bank_" + std::to_string(i) + ".busy", [&bank] { return Number(bank.busy() ? 1 : 0); }));
  }
  for (const wave::Pixel pixel : request.pixels) wave::add(pixel_taps(parts, program, pixel), taps);
  return taps;
}

}  // namespace csgsim::bit_serial_memory
