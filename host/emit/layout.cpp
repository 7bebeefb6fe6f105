#include "host/emit/layout.h"

#include <algorithm>
#include <string>

#include "host/view/projection.h"
#include "hw/base/error.h"
#include "hw/isa/colour_format.h"

namespace csgsim::emit {

namespace {

std::string parts(const Needs& needs) {
  std::string text = "2 x " + std::to_string(needs.z_bits) + " depth, " + (needs.second_colour ? "2 x " : "") +
                     std::to_string(needs.colour_bits) + " colour, 1 mask";
  const auto add = [&](unsigned bits, const char* what) {
    if (bits > 0) text += ", " + std::to_string(bits) + " " + what;
  };
  add(needs.classification.stack, "stack");
  add(needs.classification.product, "product");
  add(needs.classification.label, "label");
  add(needs.shown.width, "colour that is shown");
  return text;
}

unsigned colour_fields(const Needs& needs) {
  return 1U + (needs.second_colour ? 1 : 0) + (needs.shown.width > 0 ? 1 : 0);
}

/// Options that would make it fit, the least painful first.
std::string what_to_do(const Needs& needs, std::uint32_t memory_bits) {
  std::string text;
  const unsigned missing = total_bits(needs) - memory_bits;
  if (needs.second_colour && needs.colour_bits >= missing) text += "take --colouring rebroadcast, or ";
  if (needs.classification.total() >= missing) text += "work with fewer bits by --strategy list or auto, or ";
  const unsigned z_bits = needs.z_bits - std::min(needs.z_bits, (missing + 1) / 2);
  if (z_bits >= view::fewest_z_bits) text += "give up depth with --z-bits " + std::to_string(z_bits) + ", or ";
  const unsigned colours = colour_fields(needs);
  const unsigned colour_bits = needs.colour_bits - std::min(needs.colour_bits, (missing + colours - 1) / colours);
  if (colour_bits >= isa::fewest_colour_bits)
    text += "colours with --colour-bits " + std::to_string(colour_bits) + ", or ";
  if (needs.shown.width >= missing) text += "take a machine whose scan_out.buffers is 1, or ";
  return text + "take --memory-bits " + std::to_string(total_bits(needs));
}

}  // namespace

unsigned total_bits(const Needs& needs) {
  return 2 * needs.z_bits + colour_fields(needs) * needs.colour_bits + 1 + needs.classification.total();
}

Layout plan_layout(const Needs& needs, std::uint32_t memory_bits) {
  if (total_bits(needs) > memory_bits) {
    throw InputError("the picture needs " + std::to_string(total_bits(needs)) + " memory bits a pixel (" +
                     parts(needs) + ") and the machine has " + std::to_string(memory_bits) + "; " +
                     what_to_do(needs, memory_bits));
  }
  unsigned next = 0;
  const auto take = [&next](unsigned width) {
    const isa::Field field{static_cast<std::uint16_t>(width > 0 ? next : 0), static_cast<std::uint16_t>(width)};
    next += width;
    return field;
  };
  Layout layout;
  layout.depth = take(needs.z_bits);
  layout.candidate = take(needs.z_bits);
  layout.colour = take(needs.colour_bits);
  layout.candidate_colour = take(needs.second_colour ? needs.colour_bits : 0);
  layout.mask = take(1);
  layout.product = take(needs.classification.product);
  layout.label = take(needs.classification.label);
  for (unsigned i = 0; i < needs.classification.stack; ++i) layout.stack.push_back(take(1));
  layout.shown = needs.shown;
  return layout;
}

std::vector<isa::NamedField> named_fields(const Layout& layout) {
  std::vector<isa::NamedField> fields;
  const auto add = [&](std::string name, isa::Field field, isa::FieldRole role) {
    if (field.width > 0) fields.push_back({std::move(name), field, role});
  };
  add("Z2", layout.depth, isa::FieldRole::depth);
  add("Z1", layout.candidate, isa::FieldRole::candidate_depth);
  add("colour", layout.colour, isa::FieldRole::colour);
  add("colour1", layout.candidate_colour, isa::FieldRole::candidate_colour);
  add("mask", layout.mask, isa::FieldRole::mask);
  add("product", layout.product, isa::FieldRole::product);
  add("label", layout.label, isa::FieldRole::label);
  for (std::size_t i = 0; i < layout.stack.size(); ++i) {
    add("stack" + std::to_string(i), layout.stack[i], isa::FieldRole::stack);
  }
  add("shown", layout.shown, isa::FieldRole::shown);
  return fields;
}

}  // namespace csgsim::emit
