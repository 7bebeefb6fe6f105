#include "host/emit/layout.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "host/emit/fields.h"
#include "host/emit/no_room.h"
#include "host/view/projection.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/field_role.h"

namespace csgsim::emit {

namespace {

constexpr std::string_view fewer_bits = "work with fewer bits by --strategy list or auto";
constexpr std::string_view no_quadrics = "draw curved surfaces as facets by --curves facets";
constexpr std::string_view one_buffer = "take a machine whose scan_out.buffers is 1";

// Names of the fields for stored depths of primitives.
constexpr std::array<std::string_view, 2> stored_names{"front", "back"};
constexpr std::string_view stored_depth = "stored depth";

// Names of the fields for quadrics.
constexpr std::string_view sum_name = "sum";
constexpr std::string_view root_name = "root";
constexpr std::string_view squares_name = "squares";
constexpr std::string_view kept_name = "kept";

/// All requested fields except the second buffer, whose position is fixed. This is the only list of the fields that
/// strategies, colourings and effects add.
std::vector<FieldRequest> list_requests(const Needs& needs) {
  using isa::FieldRole;
  std::vector<FieldRequest> all{{"Z2", FieldRole::depth, needs.z_bits, "depth"},
                                {"Z1", FieldRole::candidate_depth, needs.z_bits, "depth"},
                                {"colour", FieldRole::colour, needs.colour_bits, "colour"},
                                {"colour1", FieldRole::candidate_colour, needs.second_colour ? needs.colour_bits : 0,
                                 "colour", "take --colouring rebroadcast"},
                                {"mask", FieldRole::mask, 1, "mask"}};
  all.push_back({"product", FieldRole::product, needs.classification.product, "product", fewer_bits});
  all.push_back({"label", FieldRole::label, needs.classification.label, "label", fewer_bits});
  for (unsigned i = 0; i < needs.classification.stack; ++i)
    all.push_back({"stack" + std::to_string(i), FieldRole::stack, 1, "stack", fewer_bits});
  for (unsigned i = 0; i < needs.classification.stored / (2 * needs.z_bits); ++i) {
    for (const std::string_view end : stored_names)
      all.push_back({std::string(end) + std::to_string(i), FieldRole::stored, needs.z_bits, stored_depth, fewer_bits});
  }
  all.push_back({"owner", FieldRole::owner, needs.owner_bits, "owner"});
  const FieldRequest sum{std::string(sum_name), FieldRole::scratch, needs.quadrics.sum, "sum", no_quadrics};
  const bool is_below_candidate = needs.quadrics.root_in_candidate;
  all.insert(is_below_candidate ? all.begin() + 1 : all.end(), sum);
  const unsigned root = is_below_candidate ? 0 : needs.quadrics.root;
  all.push_back({std::string(root_name), FieldRole::scratch, root, "root", no_quadrics});
  all.push_back({std::string(squares_name), FieldRole::scratch, needs.quadrics.squares, "squares", no_quadrics});
  all.push_back({std::string(kept_name), FieldRole::scratch, needs.quadrics.sum > 0 ? 1U : 0U, "kept", no_quadrics});
  for (const EffectFields& effect : needs.effects)
    for (const FieldRequest& request : effect.requests) {
      if (request.is_scratch) continue;
      all.push_back(request);
      all.back().name = std::string(effect.effect) + "." + request.name;
    }
  return all;
}

/// Places the scratch fields of effects over fields that are unused at that time.
class ScratchPlaces {
 public:
  ScratchPlaces(isa::Field candidate, unsigned end) : candidate_(candidate), end_(end), most_(end) {}

  void begin_effect() { in_candidate_ = 0, beyond_ = end_; }

  isa::Field take(unsigned width) {
    if (in_candidate_ + width <= candidate_.width) {
      in_candidate_ += width;
      return {static_cast<std::uint16_t>(candidate_.base + in_candidate_ - width), static_cast<std::uint16_t>(width)};
    }
    beyond_ += width;
    most_ = std::max(most_, beyond_);
    return {static_cast<std::uint16_t>(beyond_ - width), static_cast<std::uint16_t>(width)};
  }

  /// The first bit after all fields.
  [[nodiscard]] unsigned end() const { return most_; }

 private:
  isa::Field candidate_;
  unsigned end_;
  unsigned most_;
  unsigned in_candidate_ = 0;
  unsigned beyond_ = 0;
};

/// The purposes of the bits, for the error message; requests for the same purpose are combined.
std::string purposes_text(const Needs& needs, unsigned scratch) {
  std::vector<FieldRequest> left = list_requests(needs);
  std::string text;
  while (!left.empty()) {
    const FieldRequest first = left.front();
    const auto same = [&](const FieldRequest& one) { return one.what == first.what && one.width == first.width; };
    const auto count = std::count_if(left.begin(), left.end(), same);
    std::erase_if(left, same);
    if (first.width == 0) continue;
    if (!text.empty()) text += ", ";
    if (first.width == 1) {
      text += std::to_string(count);
    } else {
      text += (count > 1 ? std::to_string(count) + " x " : "") + std::to_string(first.width);
    }
    text += " " + std::string(first.what);
  }
  if (scratch > 0) text += ", " + std::to_string(scratch) + " scratch";
  if (needs.shown.width > 0) text += ", " + std::to_string(needs.shown.width) + " displayed colour";
  return text;
}

/// Number of requests for a field of that purpose and width.
unsigned fields_of_width(const Needs& needs, std::string_view what, unsigned width) {
  unsigned count = 0;
  for (const FieldRequest& request : list_requests(needs)) count += request.what == what && request.width == width;
  return count;
}

/// Options that would make it fit, those with the smallest effect on the picture first.
std::string suggest_options(const Needs& needs, std::uint32_t memory_bits) {
  std::string text;
  const unsigned missing = total_bits(needs) - memory_bits;
  std::vector<FieldRequest> left = list_requests(needs);
  while (!left.empty()) {
    const std::string_view without = left.front().without;
    unsigned saved = 0;
    std::erase_if(left, [&](const FieldRequest& one) {
      if (one.without != without) return false;
      saved += one.width;
      return true;
    });
    if (!without.empty() && saved >= missing) text += std::string(without) + ", or ";
  }
  const unsigned depths =
      fields_of_width(needs, "depth", needs.z_bits) + fields_of_width(needs, stored_depth, needs.z_bits);
  const unsigned z_bits = needs.z_bits - std::min(needs.z_bits, (missing + depths - 1) / depths);
  if (z_bits >= view::min_z_bits)
    text += "lower the depth resolution with --z-bits " + std::to_string(z_bits) + ", or ";
  const unsigned colours = fields_of_width(needs, "colour", needs.colour_bits) + (needs.shown.width > 0 ? 1 : 0);
  const unsigned colour_bits = needs.colour_bits - std::min(needs.colour_bits, (missing + colours - 1) / colours);
  if (colour_bits >= isa::minimum_colour_bits)
    text += "the colour resolution with --colour-bits " + std::to_string(colour_bits) + ", or ";
  if (needs.shown.width >= missing) text += std::string(one_buffer) + ", or ";
  if (total_bits(needs) <= isa::max_memory_bits)
    return text + "take --memory-bits " + std::to_string(total_bits(needs));
  return text + "take a smaller model: no machine has more than " + std::to_string(isa::max_memory_bits);
}

/// The layout's member for a field of quadrics; null for other names.
isa::Field* quadric_field(Layout& layout, std::string_view name) {
  if (name == sum_name) return &layout.sum;
  if (name == root_name) return &layout.root;
  if (name == squares_name) return &layout.squares;
  return name == kept_name ? &layout.kept : nullptr;
}

void set_field(Layout& layout, const FieldRequest& request, isa::Field field) {
  switch (request.role) {
    case isa::FieldRole::depth: layout.depth = field; return;
    case isa::FieldRole::candidate_depth: layout.candidate = field; return;
    case isa::FieldRole::colour: layout.colour = field; return;
    case isa::FieldRole::candidate_colour: layout.candidate_colour = field; return;
    case isa::FieldRole::mask: layout.mask = field; return;
    case isa::FieldRole::stack: layout.stack.push_back(field); return;
    case isa::FieldRole::product: layout.product = field; return;
    case isa::FieldRole::label: layout.label = field; return;
    case isa::FieldRole::stored: layout.stored.push_back(field); return;
    case isa::FieldRole::owner: layout.owner = field; return;
    case isa::FieldRole::scratch:
    case isa::FieldRole::shown:
    case isa::FieldRole::effect: break;
  }
  if (isa::Field* const known = quadric_field(layout, request.name)) {
    *known = field;
  } else {
    layout.effects.push_back({request.name, field, request.role});
  }
}

struct Planned {
  Layout layout;
  unsigned without_scratch = 0;  ///< bits without the scratch of effects
  unsigned bits = 0;             ///< all bits except the second buffer
};

Planned plan(const Needs& needs) {
  Planned planned;
  unsigned next = 0;
  for (const FieldRequest& request : list_requests(needs)) {
    const isa::Field field{static_cast<std::uint16_t>(request.width > 0 ? next : 0),
                           static_cast<std::uint16_t>(request.width)};
    set_field(planned.layout, request, field);
    next += request.width;
  }
  if (needs.quadrics.root_in_candidate)
    planned.layout.root = subfield(planned.layout.candidate, 0, needs.quadrics.root);
  planned.layout.light = needs.quadrics.in_place ? planned.layout.candidate : planned.layout.sum;
  if (needs.quadrics.in_place) planned.layout.kept = planned.layout.mask;
  ScratchPlaces places(planned.layout.candidate, next);
  for (const EffectFields& effect : needs.effects) {
    places.begin_effect();
    for (const FieldRequest& request : effect.requests) {
      if (!request.is_scratch) continue;
      planned.layout.effects.push_back(
          {std::string(effect.effect) + "." + request.name, places.take(request.width), isa::FieldRole::scratch});
    }
  }
  planned.layout.shown = needs.shown;
  planned.without_scratch = next;
  planned.bits = places.end();
  return planned;
}

/// Names a field in two parts, low and high, if it is wider than max_field_width.
void add_in_parts(std::vector<isa::NamedField>& fields, std::string_view name, isa::Field field) {
  const unsigned low = std::min<unsigned>(field.width, isa::max_field_width);
  if (low > 0) fields.push_back({std::string(name), subfield(field, 0, low), isa::FieldRole::scratch});
  if (low < field.width)
    fields.push_back({std::string(name) + "_high", subfield(field, low, field.width - low), isa::FieldRole::scratch});
}

}  // namespace

isa::Field Layout::of(std::string_view effect, std::string_view name) const {
  const std::string full = std::string(effect) + "." + std::string(name);
  const auto found =
      std::find_if(effects.begin(), effects.end(), [&](const isa::NamedField& one) { return one.name == full; });
  if (found == effects.end()) throw std::logic_error("no effect requested the field " + full);
  return found->field;
}

ClassificationBits max_bits(const ClassificationBits& a, const ClassificationBits& b) {
  return {std::max(a.stack, b.stack), std::max(a.product, b.product), std::max(a.label, b.label),
          std::max(a.stored, b.stored)};
}

unsigned total_bits(const Needs& needs) { return plan(needs).bits + needs.shown.width; }

Layout plan_layout(const Needs& needs, std::uint32_t memory_bits) {
  const Planned planned = plan(needs);
  if (total_bits(needs) > memory_bits) {
    throw OutOfPixelMemory("the picture needs " + std::to_string(total_bits(needs)) + " memory bits a pixel (" +
                               purposes_text(needs, planned.bits - planned.without_scratch) + ") and the machine has " +
                               std::to_string(memory_bits) + "; " + suggest_options(needs, memory_bits),
                           total_bits(needs));
  }
  return planned.layout;
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
  for (std::size_t i = 0; i < layout.stored.size(); ++i)
    add(std::string(stored_names.at(i % 2)) + std::to_string(i / 2), layout.stored[i], isa::FieldRole::stored);
  add("owner", layout.owner, isa::FieldRole::owner);
  add_in_parts(fields, sum_name, layout.sum);
  if (!layout.root.overlaps(layout.candidate)) add(std::string(root_name), layout.root, isa::FieldRole::scratch);
  add(std::string(squares_name), layout.squares, isa::FieldRole::scratch);
  if (layout.kept != layout.mask) add(std::string(kept_name), layout.kept, isa::FieldRole::scratch);
  unsigned end = 0;
  for (const isa::NamedField& named : fields) end = std::max(end, named.field.end());
  for (const isa::NamedField& named : layout.effects) {
    if (named.role != isa::FieldRole::scratch) end = std::max(end, named.field.end());
  }
  unsigned scratch_end = end;
  for (const isa::NamedField& named : layout.effects) {
    if (named.role != isa::FieldRole::scratch) add(named.name, named.field, named.role);
    scratch_end = std::max(scratch_end, named.field.end());
  }
  for (unsigned i = 0; end < scratch_end; ++i) {
    const unsigned width = std::min(isa::max_field_width, scratch_end - end);
    add("scratch" + std::to_string(i), {static_cast<std::uint16_t>(end), static_cast<std::uint16_t>(width)},
        isa::FieldRole::scratch);
    end += width;
  }
  add("shown", layout.shown, isa::FieldRole::shown);
  return fields;
}

}  // namespace csgsim::emit
