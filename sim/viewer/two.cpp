#include "sim/viewer/two.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/text.h"
#include "sim/engine/numbers.h"
#include "sim/lockstep/comparison.h"
#include "sim/viewer/png.h"

namespace csgsim::viewer {

namespace {

using Channels = std::array<std::uint8_t, 3>;

struct Difference {
  std::vector<std::uint8_t> picture;  ///< A's in light grey, with the pixels marked that differ
  std::uint64_t pixels = 0;
  std::size_t first = 0;
};

Difference difference(const DrawnProgram& a, const DrawnProgram& b) {
  Difference found;
  found.picture.reserve(3 * a.frame.colour.size());
  for (std::size_t i = 0; i < a.frame.colour.size(); ++i) {
    const Channels of_a = isa::unpack_colour(a.frame.colour[i], a.program.colour.width);
    const Channels of_b = isa::unpack_colour(b.frame.colour[i], b.program.colour.width);
    const bool is_same = of_a == of_b && a.frame.owner[i] == b.frame.owner[i];
    if (!is_same && found.pixels++ == 0) found.first = i;
    const auto grey = static_cast<std::uint8_t>(150 + (of_a[0] + 2 * of_a[1] + of_a[2]) / 10);
    const Channels shown = is_same ? Channels{grey, grey, grey} : mark_colour;
    found.picture.insert(found.picture.end(), shown.begin(), shown.end());
  }
  return found;
}

std::string instruction_text(const isa::Program& program, std::uint64_t number) {
  const engine::Numbers numbers(program);
  if (number >= numbers.count()) return "nothing more";
  const engine::Place place = numbers.place(number);
  return isa::text_of(program.segments[place.segment].instructions[place.index], program.facts.fields);
}

}  // namespace

nlohmann::ordered_json two_at_once(const DrawnProgram& a, const DrawnProgram& b) {
  if (a.frame.width != b.frame.width || a.frame.height != b.frame.height) {
    throw InputError(fmt::format("A is {} x {} pixels and B {} x {}; give both the same size", a.frame.width,
                                 a.frame.height, b.frame.width, b.frame.height));
  }
  const Difference found = difference(a, b);
  nlohmann::ordered_json told{{"pixels", found.pixels}, {"first", nullptr}};
  if (found.pixels > 0) told["first"] = {found.first % a.frame.width, found.first / a.frame.width};
  told["picture"] = png_url(found.picture, a.frame.width, a.frame.height);
  told["instruction"] = nullptr;
  if (const std::optional<std::uint64_t> other = lockstep::first_other_instruction(a.program, b.program)) {
    told["instruction"] = {
        {"number", *other}, {"a", instruction_text(a.program, *other)}, {"b", instruction_text(b.program, *other)}};
  }
  return told;
}

}  // namespace csgsim::viewer
