#include "hw/wave/pixel_taps.h"

#include <fmt/format.h>

#include <set>

#include "hw/isa/facts.h"

namespace csgsim::wave {

namespace {

Show display_form(const isa::NamedField& named) {
  if (named.field.width == 1) return Show::bits;
  const bool is_depth = named.role == isa::FieldRole::depth || named.role == isa::FieldRole::candidate_depth;
  return is_depth ? Show::number : Show::hexadecimal;
}

}  // namespace

std::string pixel_part_name(Pixel pixel) { return fmt::format("pixel_{}_{}", pixel.x, pixel.y); }

std::vector<Tap> field_taps(const std::string& part, const isa::Program& program,
                            const std::function<Number(isa::Field)>& read) {
  std::vector<Tap> taps;
  std::set<std::string> names;
  for (const isa::NamedField& named : program.facts->fields) {
    std::string name = identifier(named.name);
    if (!names.insert(name).second) name += fmt::format("_{}", named.field.base);
    taps.push_back({fmt::format("{}.{}", part, name), display_form(named), named.field.width,
                    [read, field = named.field] { return read(field); }, nullptr});
  }
  return taps;
}

}  // namespace csgsim::wave
