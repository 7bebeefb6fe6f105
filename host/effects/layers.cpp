#include "host/effects/layers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "host/effects/blend.h"
#include "host/effects/pane_pieces.h"
#include "host/emit/early_out.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/field_role.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

using emit::FieldRequest;
using isa::Field;
using isa::Opcode;

constexpr std::string_view effect = "transparency";
constexpr std::string_view without =
    "use --set effects.transparency.method=screen-door, or draw transparent primitives as opaque by --set "
    "effects.transparency.on=false";

/// Field name that sim/observe/frame.h also uses.
constexpr std::string_view nearest_depth = "nearest_depth";
constexpr std::string_view nearest_colour = "nearest_colour";

constexpr std::array<std::string_view, 3> sum_names{"red", "green", "blue"};

/// Depth peeling (Everitt, Interactive Order-Independent Transparency, 2001, after Mammen, Transparency and
/// Antialiasing Algorithms Implemented with the Virtual Pixel Maps Technique, 1989): peels off the panes, nearest
/// first, and sums their contributions to the colour. Weights are in 1/256. The weight of the nearest pane is its
/// opacity; that of each other pane is its opacity times the light that the nearer panes let through; that of the
/// opaque surface is the remainder. The weights add up to 256.
class Peeling {
 public:
  Peeling(const emit::Context& context, emit::Broadcast& out, const Panes& panes)
      : context_(context),
        out_(out),
        panes_(panes),
        layers_(panes.layers[context.segment]),
        last_(field(nearest_depth)),
        pane_colour_(field(nearest_colour)),
        product_(field("product")),
        glass_(colour_channels(pane_colour_)),
        colour_(colour_channels(context.layout.colour)) {}

  void run() {
    peel(last_, context_.beyond);
    keep_found(last_);
    const std::size_t begin = out_.size();
    if (layers_ == 1) {
      blend_one();
    } else {
      start_sums();
      peel_behind(2);
      finish_sums();
    }
    emit_early_out(context_, out_, begin, emit::effect_origin);
  }

 private:
  [[nodiscard]] Field field(std::string_view name) const { return context_.layout.of(effect, name); }
  [[nodiscard]] Field sum(std::size_t channel) const { return field(sum_names.at(channel)); }
  [[nodiscard]] Field mask() const { return context_.layout.mask; }

  /// Draws the nearest panes behind `beyond` and in front of the opaque surfaces into `depth` and the panes' colour.
  void peel(Field depth, Field beyond) {
    emit::Layout layout = context_.layout;
    layout.depth = depth;
    layout.colour = pane_colour_;
    if (layout.owner.width > 0) layout.owner = field("owner");
    emit::Context inner = with_layout(context_, layout);
    inner.beyond = beyond;
    inner.drawn = &panes_.drawn;
    out_.origin = emit::effect_origin;
    enable_drawing(context_, out_);
    out_.plain(Opcode::copy, depth, context_.layout.depth);
    if (layout.owner.width > 0) out_.plain(Opcode::set_constant, layout.owner, {}, 0);
    emit_surfaces(inner, out_);
    emit_shading(inner, out_);
  }

  /// E and mask := 1 where a pane is in front of the opaque surface.
  void keep_found(Field depth) {
    out_.origin = emit::effect_origin;
    enable_drawing(context_, out_);
    out_.plain(Opcode::field_lt, depth, context_.layout.depth);
    out_.plain(Opcode::enable_store, mask());
  }

  /// Calls visit(opacity) for each opacity, with E 1 at the pixels of the mask whose pane has that opacity.
  template <class Visit>
  void for_opacities(const Visit& visit) {
    for (std::size_t i = 0; i < panes_.opacities.size(); ++i) {
      out_.plain(Opcode::enable_load, mask());
      if (field("opacity").width > 0) out_.equals(field("opacity"), static_cast<std::uint32_t>(i));
      visit(panes_.opacities[i]);
    }
  }

  /// Blends one layer over the opaque surface.
  void blend_one() {
    for_opacities([&](unsigned opacity) { emit_blend(out_, context_.layout.colour, pane_colour_, opacity, product_); });
  }

  void start_sums() {
    for_opacities([&](unsigned opacity) {
      for (std::size_t i = 0; i < glass_.size(); ++i) {
        out_.plain(Opcode::set_constant, sum(i), {}, full_weight / 2);
        emit_multiply_add(out_, sum(i), opacity, glass_.at(i));
      }
      out_.plain(Opcode::set_constant, field("through"), {}, full_weight - opacity);
    });
  }

  /// Peels layer number `layer` and all layers behind it. `last_` is the depth of the previous layer, if the pixel has
  /// one.
  void peel_behind(unsigned layer) {
    if (layer > layers_) return;
    peel(field("next"), last_);
    keep_found(field("next"));
    const std::size_t begin = out_.size();
    add_layer();
    out_.plain(Opcode::enable_load, mask());
    out_.plain(Opcode::copy, last_, field("next"));
    peel_behind(layer + 1);
    emit_early_out(context_, out_, begin, emit::effect_origin);
  }

  void add_layer() {
    const Field through = field("through");
    const Field product = subfield(product_, 0, 2 * weight_bits);
    for_opacities([&](unsigned opacity) {
      out_.plain(Opcode::set_constant, product, {}, full_weight / 2);
      emit_multiply_add(out_, product, opacity, through);
    });
    const Field weight = subfield(product, weight_bits, weight_bits);
    out_.plain(Opcode::enable_load, mask());
    // Uses a - b = not (not a + b).
    out_.plain(Opcode::bit_not, through, through);
    out_.plain(Opcode::add, through, weight);
    out_.plain(Opcode::bit_not, through, through);
    add_weighted(weight, glass_);
  }

  void finish_sums() {
    keep_found(last_);
    add_weighted(field("through"), colour_);
    out_.plain(Opcode::enable_load, mask());
    for (std::size_t i = 0; i < colour_.size(); ++i)
      out_.plain(Opcode::copy, colour_.at(i), subfield(sum(i), weight_bits, colour_.at(i).width));
  }

  /// sums += weight * colour, where the mask is 1.
  void add_weighted(Field weight, const std::array<Field, 3>& channels) {
    for (unsigned i = 0; i < weight_bits; ++i) {
      out_.plain(Opcode::enable_load, mask());
      out_.plain(Opcode::enable_and, subfield(weight, i, 1));
      for (std::size_t c = 0; c < channels.size(); ++c)
        out_.plain(Opcode::add, subfield(sum(c), i, sum(c).width - i), channels.at(c));
    }
  }

  const emit::Context& context_;
  emit::Broadcast& out_;
  const Panes& panes_;
  unsigned layers_;
  Field last_;         ///< depth of the last peeled layer; at pixels without layers, of the opaque surface
  Field pane_colour_;  ///< colour of the layer being peeled
  Field product_;
  std::array<Field, 3> glass_;   ///< channels of the layer's colour
  std::array<Field, 3> colour_;  ///< channels of the drawing's colour
};

/// Rounds the opacity to a multiple of 1/256.
unsigned rounded_opacity(double opacity) {
  const auto nearest = static_cast<unsigned>(view::to_fixed(opacity, weight_bits).value_or(0));
  return std::min(nearest, full_weight - 1);
}

unsigned count_layers(const emit::SegmentPlan& segment, const std::vector<bool>& drawn) {
  std::vector<view::PixelRect> rectangles;
  for (const emit::PlannedSurface& one : segment.surfaces)
    if (drawn[one.primitive()]) rectangles.push_back(one.block.pixels);
  return max_overlap(rectangles);
}

}  // namespace

unsigned max_overlap(std::span<const view::PixelRect> rectangles) {
  // The maximum occurs at the left edge of one rectangle and the upper edge of another.
  unsigned most = 0;
  for (const view::PixelRect& at : rectangles) {
    std::vector<std::int32_t> tops;
    std::vector<std::int32_t> bottoms;
    for (const view::PixelRect& one : rectangles) {
      if (one.empty() || one.x0 > at.x0 || one.x1 < at.x0) continue;
      tops.push_back(one.y0);
      bottoms.push_back(one.y1);
    }
    std::sort(tops.begin(), tops.end());
    std::sort(bottoms.begin(), bottoms.end());
    std::size_t ended = 0;
    for (std::size_t begun = 0; begun < tops.size(); ++begun) {
      while (bottoms[ended] < tops[begun]) ++ended;
      most = std::max(most, static_cast<unsigned>(begun + 1 - ended));
    }
  }
  return most;
}

Panes find_panes(const emit::Drawing& drawing, unsigned max_layers) {
  Panes panes;
  std::vector<unsigned> of_primitives;
  for (const lighting::Finish& finish : drawing.look.finishes) {
    of_primitives.push_back(finish.opacity < 1 ? rounded_opacity(finish.opacity) : 0);
    panes.drawn.push_back(of_primitives.back() > 0);
    if (panes.drawn.back()) panes.opacities.push_back(of_primitives.back());
  }
  std::vector<unsigned>& all = panes.opacities;
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (const unsigned one : of_primitives)
    panes.kinds.push_back(static_cast<std::uint32_t>(std::lower_bound(all.begin(), all.end(), one) - all.begin()));
  panes.pieces = touching_pieces(drawing, panes.drawn);
  for (const emit::SegmentPlan& segment : drawing.plan.segments) {
    panes.layers.push_back(std::min(max_layers, count_layers(segment, panes.drawn)));
    panes.surfaces = std::max(panes.surfaces, static_cast<std::uint32_t>(segment.surfaces.size()));
  }
  return panes;
}

std::vector<FieldRequest> layer_fields(unsigned z_bits, unsigned colour_bits, std::span<const Panes* const> panes,
                                       bool has_owners) {
  using isa::FieldRole;
  unsigned layers = 0;
  std::size_t opacities = 1;
  std::uint32_t surfaces = 1;
  for (const Panes* const one : panes) {
    for (const unsigned segment : one->layers) layers = std::max(layers, segment);
    opacities = std::max(opacities, one->opacities.size());
    surfaces = std::max(surfaces, one->surfaces);
  }
  if (layers == 0) return {};
  const std::array<unsigned, 3> widths = isa::channel_widths(colour_bits);
  std::vector<FieldRequest> all{
      {std::string(nearest_depth), FieldRole::effect, z_bits, "depth", without},
      {std::string(nearest_colour), FieldRole::effect, colour_bits, "colour", without},
      {"opacity", FieldRole::effect, static_cast<unsigned>(std::bit_width(opacities - 1)), "opacity", without},
      {"product", FieldRole::scratch, 2 * weight_bits, "product", without, true}};
  if (has_owners)
    all.push_back({"owner", FieldRole::effect, static_cast<unsigned>(std::bit_width(surfaces)), "owner", without});
  if (layers == 1) return all;
  all.push_back({"next", FieldRole::effect, z_bits, "depth", without});
  all.push_back({"through", FieldRole::effect, weight_bits, "light let through", without});
  for (std::size_t i = 0; i < widths.size(); ++i) {
    all.push_back(
        {std::string(sum_names.at(i)), FieldRole::effect, widths.at(i) + weight_bits, "sum of layers", without});
  }
  return all;
}

void emit_layers(const emit::Context& context, emit::Broadcast& out, const Panes& panes) {
  if (panes.layers[context.segment] > 0) Peeling(context, out, panes).run();
}

void emit_joints(const emit::Context& context, emit::Broadcast& out, const Panes& panes,
                 const emit::PlannedSurface& planned) {
  if (context.drawn != &panes.drawn) return;
  emit_outside(context, out, planned, panes.pieces[planned.primitive()], context.layout.mask);
}

void emit_opacity(const emit::Context& context, emit::Broadcast& out, const Panes& panes, std::uint32_t primitive) {
  const bool is_peeling = context.drawn == &panes.drawn;
  if (!is_peeling) return;
  const Field opacity = context.layout.of(effect, "opacity");
  if (opacity.width == 0) return;
  out.origin = {isa::Purpose::merge, primitive, isa::no_node};
  out.plain(Opcode::set_constant, opacity, {}, panes.kinds[primitive]);
}

}  // namespace csgsim::effects
