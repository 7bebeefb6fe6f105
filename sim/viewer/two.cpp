#include "sim/viewer/two.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>

#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/isa/text.h"
#include "sim/engine/numbers.h"
#include "sim/lockstep/comparison.h"
#include "sim/viewer/png.h"

namespace csgsim::viewer {

namespace {

std::string instruction_text(const isa::Program& program, std::uint64_t number) {
  const engine::Numbers numbers(program);
  if (number >= numbers.count()) return "the end of the Program";
  const engine::Place place = numbers.place(number);
  return isa::text_of(program.segments[place.segment].instructions[place.index], program.facts->fields);
}

}  // namespace

nlohmann::ordered_json compare_drawings(const report::DrawnProgram& a, const report::DrawnProgram& b) {
  if (a.frame.width != b.frame.width || a.frame.height != b.frame.height) {
    throw InputError(fmt::format("A is {} x {} pixels and B {} x {}; give both the same size", a.frame.width,
                                 a.frame.height, b.frame.width, b.frame.height));
  }
  const report::Difference found = report::difference_of(a, b, "", "");
  nlohmann::ordered_json json{{"pixels", found.pixels}, {"first", nullptr}};
  if (found.pixels > 0) json["first"] = {found.first % a.frame.width, found.first / a.frame.width};
  json["picture"] = png_url(found.picture.png);
  json["instruction"] = nullptr;
  if (const std::optional<std::uint64_t> other = lockstep::first_different_instruction(a.program, b.program)) {
    json["instruction"] = {
        {"number", *other}, {"a", instruction_text(a.program, *other)}, {"b", instruction_text(b.program, *other)}};
  }
  return json;
}

}  // namespace csgsim::viewer
