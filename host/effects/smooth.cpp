#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <vector>

#include "host/effects/blend.h"
#include "host/effects/rows.h"
#include "host/emit/facet_colour.h"
#include "host/emit/facet_geometry.h"
#include "host/model/shapes.h"
#include "host/view/projection.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

struct Settings {
  double least_difference = 1;
};

void visit_keys(Settings& settings, auto&& visit) {
  visit(scene::number_key("least_difference", "levels of a channel", 0, 255,
                          "facets whose vertices differ by less get a single colour"),
        settings.least_difference);
}

/// A sample for the fit: a position in the picture, with levels of red, green and blue.
struct Sample {
  glm::dvec2 at;
  glm::dvec3 levels;
};

glm::dvec3 top_levels(unsigned colour_bits) {
  const std::array<unsigned, 3> widths = isa::channel_widths(colour_bits);
  return {(1U << widths[0]) - 1, (1U << widths[1]) - 1, (1U << widths[2]) - 1};
}

/// The levels of the illuminated true surface at the facet's vertices. Empty if the facet is the surface itself or
/// reaches behind the eye.
std::vector<Sample> take_samples(const emit::Context& context, const emit::Facet& facet) {
  std::vector<Sample> samples;
  const model::Primitive& primitive = context.tree.primitives[facet.primitive];
  if (facet.at != emit::At::plane || emit::is_flat(primitive, emit::outward_normal(context, facet))) return samples;
  const glm::dmat4 to_own = glm::inverse(primitive.transform);
  const double sign = context.complemented(facet.primitive) ? -1.0 : 1.0;
  const glm::dvec3 facet_normal = sign * emit::local_normal(context, facet);
  const view::EyeSpace space = view::eye_space(context.view.camera, context.view.sampling);
  const lighting::Finish& finish = context.look.finishes[facet.primitive];
  const glm::dvec3 top = top_levels(context.options.colour_bits);
  for (const glm::dvec3& vertex : emit::facet_vertices(context, facet)) {
    const std::optional<glm::dvec3> own =
        model::normal_at(primitive.shape, glm::dvec3(to_own * glm::dvec4(vertex, 1)), facet_normal);
    const glm::dvec3 in_eye = space.to_eye(vertex);
    if (!own || (space.perspective && in_eye.z <= 0)) return {};
    const glm::dvec3 normal = sign * glm::normalize(glm::transpose(glm::dmat3(to_own)) * *own);
    context.counted.add(&isa::Preparation::colours);
    const glm::dvec3 colour = lighting::lit_colour(context.lighting(), finish.material, finish.colour,
                                                   {in_eye, emit::in_camera_axes(context.view.camera, normal)});
    samples.push_back({glm::dvec2(space.to_picture(in_eye)), glm::clamp(colour, 0.0, 1.0) * top});
  }
  return samples;
}

/// Levels as linear functions of column and row.
struct Fit {
  glm::dvec2 middle;      ///< mean position of the samples
  glm::dvec3 at_middle;   ///< levels at `middle`
  glm::dvec3 per_column;  ///< change of levels per column
  glm::dvec3 per_row;     ///< change of levels per row
};

/// Least squares fit; empty if the samples are collinear.
std::optional<Fit> fit(const std::vector<Sample>& samples) {
  Fit result{glm::dvec2(0), glm::dvec3(0), glm::dvec3(0), glm::dvec3(0)};
  const auto count = static_cast<double>(samples.size());
  for (const Sample& one : samples) {
    result.middle += one.at / count;
    result.at_middle += one.levels / count;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  glm::dvec3 x{0};
  glm::dvec3 y{0};
  for (const Sample& one : samples) {
    const glm::dvec2 d = one.at - result.middle;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
    x += d.x * (one.levels - result.at_middle);
    y += d.y * (one.levels - result.at_middle);
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-6 * (xx + yy) * (xx + yy))) return std::nullopt;
  result.per_column = (x * yy - y * xy) / determinant;
  result.per_row = (y * xx - x * xy) / determinant;
  return result;
}

/// The bounding rectangle of the facet's vertices plus one pixel on each side. It contains the facet's pixels in spite
/// of rounding.
view::PixelRect bounding_pixels(const std::vector<Sample>& samples, const view::PixelRect& pixels) {
  glm::dvec2 low = samples.front().at;
  glm::dvec2 high = low;
  for (const Sample& one : samples) {
    low = glm::min(low, one.at);
    high = glm::max(high, one.at);
  }
  // Clamped to the picture, so that the conversion does not overflow.
  const auto pixel = [](double place, std::int32_t least, std::int32_t most) {
    return static_cast<std::int32_t>(std::clamp(place, static_cast<double>(least), static_cast<double>(most)));
  };
  return {pixel(std::floor(low.x) - 1, pixels.x0, pixels.x1), pixel(std::floor(low.y) - 1, pixels.y0, pixels.y1),
          pixel(std::ceil(high.x) + 1, pixels.x0, pixels.x1), pixel(std::ceil(high.y) + 1, pixels.y0, pixels.y1)};
}

double greatest_difference(const std::vector<Sample>& samples) {
  glm::dvec3 low = samples.front().levels;
  glm::dvec3 high = low;
  for (const Sample& one : samples) {
    low = glm::min(low, one.levels);
    high = glm::max(high, one.levels);
  }
  const glm::dvec3 difference = high - low;
  return std::max({difference.x, difference.y, difference.z});
}

/// The expressions of red, green and blue; the floor of each is the level. Empty if coefficients do not fit.
std::optional<std::array<view::FixedLinear, 3>> make_expressions(const Fit& fitted, const view::Sampling& sampling) {
  std::array<view::FixedLinear, 3> channels;
  const glm::dvec2 centre((sampling.width - 1.0) / 2.0, (sampling.height - 1.0) / 2.0);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto c = static_cast<glm::length_t>(i);
    const double at_centre = fitted.at_middle[c] + fitted.per_column[c] * (centre.x - fitted.middle.x) +
                             fitted.per_row[c] * (centre.y - fitted.middle.y);
    const auto fixed = view::to_fixed({fitted.per_column[c], fitted.per_row[c], at_centre + 0.5},
                                      sampling.fraction_bits, sampling.width, sampling.height);
    if (!fixed) return std::nullopt;
    channels[i] = *fixed;
  }
  return channels;
}

/// Leaves E at 1 where the level is in the channel's range.
void emit_clamp(emit::Broadcast& out, const view::FixedLinear& level, std::int64_t beyond,
                const view::PixelRect& pixels) {
  const view::Range range = view::range_over(level, pixels);
  if (range.low < 0) out.edge(isa::Opcode::edge_not_negative, level, pixels);
  if (range.high >= beyond) out.edge(isa::Opcode::edge_negative, {level.a, level.b, level.c - beyond}, pixels);
}

class Smooth final : public emit::EffectOf<Settings> {
 public:
  bool shade(const emit::EffectCall& call, emit::Broadcast& out, const emit::Facet& facet, isa::Field field,
             const view::PixelRect& pixels) const override {
    const emit::Context& context = call.context;
    const std::vector<Sample> samples = take_samples(context, facet);
    if (samples.size() < 3) return false;
    if (greatest_difference(samples) < settings.least_difference) return false;
    const std::optional<Fit> fitted = fit(samples);
    if (!fitted) return false;
    const auto channels = make_expressions(*fitted, context.view.sampling);
    if (!channels) return false;
    // Pixels that the expressions exclude keep the colour of the facet.
    out.plain(isa::Opcode::set_constant, field, {}, emit::facet_colour(context, facet));
    const view::PixelRect box = bounding_pixels(samples, pixels);
    out.clip(box, pixels);
    const std::array<isa::Field, 3> levels = colour_channels(field);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      emit_clamp(out, (*channels)[i], std::int64_t{1} << (levels[i].width + context.view.sampling.fraction_bits), box);
    }
    for (std::size_t i = 0; i < levels.size(); ++i)
      out.surface(isa::Opcode::load_linear, levels[i], (*channels)[i], box);
    return true;
  }
};

}  // namespace

extern const emit::EffectRow smooth{
    .section = scene::effect_section<Settings>("effects.smooth", "curved solids look round even with few facets"),
    .technique =
        "Gouraud 1971: light is computed at the vertices, here with the normals of the true surface; a linear "
        "expression per channel, fitted by least squares, is loaded as in Fuchs et al. 1985",
    .parts = emit::parts_of<Smooth>,
    .takes_quadrics = true};

}  // namespace csgsim::effects
