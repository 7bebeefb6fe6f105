#include "host/emit/curved_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <vector>

#include "host/emit/digits.h"
#include "host/emit/fields.h"
#include "host/emit/light_fit.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Field;
using isa::Opcode;

/// Additional bits of a cosine, and of the sum that becomes a channel, over those of the widest channel: a cosine has a
/// sign and a range up to 2; a sum has a fraction and headroom for overexposure.
constexpr unsigned more_bits = 3;

/// Fraction bits of the linear expressions of cosines.
constexpr unsigned fraction_bits = 8;

/// Maximum number of fraction bits of the sum; fewer if a bright light needs the bits.
constexpr unsigned max_sum_fraction = 2;

/// Tolerances: how far a fitted cosine may exceed its greatest value at the fitted points, and how many steps the depth
/// may be off.
constexpr double slack = 0.1;
constexpr double slack_steps = 2;

unsigned widest_channel(unsigned colour_bits) {
  const std::array<unsigned, 3> widths = isa::channel_widths(colour_bits);
  return *std::max_element(widths.begin(), widths.end());
}

/// A cosine in units of 1 / `one`: (plane >> fraction_bits) plus or minus (depth >> drop).
struct ScaledCosine {
  double one = 1;
  view::FixedLinear plane;
  bool has_depth = true;
  bool is_minus = false;
  unsigned drop = 0;
};

/// Scales the cosine so that a depth step is a power of two of the unit. `one` is between `least_one` and twice that,
/// or less if a depth step is coarser.
std::optional<ScaledCosine> scaled(const LightFit& fit, double least_one, const view::Sampling& sampling) {
  ScaledCosine cosine;
  const double per_step = std::abs(fit.per_step);
  const double steps = std::ldexp(1.0, static_cast<int>(sampling.z_bits));
  cosine.has_depth = per_step * steps * least_one >= 2;
  cosine.one = 2 * least_one - 1;
  if (cosine.has_depth) {
    cosine.is_minus = fit.per_step < 0;
    cosine.drop = static_cast<unsigned>(std::max(0.0, std::floor(std::log2(1.0 / (least_one * per_step)))));
    cosine.one = std::ldexp(1.0, -static_cast<int>(cosine.drop)) / per_step;
  }
  // Compensates the mean loss of 1/2 by the expression's floor, and the loss by the dropped bits of the depth.
  const double dropped = std::ldexp(1.0, -static_cast<int>(cosine.drop));
  const double lost = (1.0 - dropped) / 2 - fit.off_steps * dropped;
  const double back =
      cosine.has_depth ? (cosine.is_minus ? -lost : lost) : fit.per_step * fit.middle_depth * cosine.one;
  const view::RealLinear plane{fit.plane.a * cosine.one, fit.plane.b * cosine.one,
                               fit.plane.at_centre * cosine.one + 0.5 + back};
  const auto fixed = view::to_fixed(plane, fraction_bits, sampling.width, sampling.height);
  if (!fixed) return std::nullopt;
  cosine.plane = *fixed;
  return cosine;
}

class Painter {
 public:
  Painter(const Context& context, Broadcast& out, const Facet& facet, Field field, const view::PixelRect& pixels)
      : context_(context),
        out_(out),
        facet_(facet),
        field_(field),
        pixels_(pixels),
        finish_(context.look.finishes[facet.primitive]) {
    const unsigned bits = widest_channel(field.width) + more_bits;
    cosine_ = subfield(context.layout.light, 0, bits);
    sum_ = subfield(context.layout.light, bits, bits);
  }

  void paint() {
    brightest_ = finish_.colour * context_.lighting().ambient * finish_.material.ambient;
    const std::uint32_t ambient = packed_colour(brightest_, field_.width);
    std::vector<Light> lights;
    for (const lighting::CameraSpaceLight& light : context_.lighting().lights) {
      const LightFit fit = fit_light(context_, facet_, light);
      const glm::dvec3 brightness = finish_.colour * light.colour * finish_.material.diffuse;
      const auto cosine = scaled(fit, std::ldexp(1.0, static_cast<int>(cosine_.width) - 3), context_.view.sampling);
      const bool is_seen = (brightness.r > 0 || brightness.g > 0 || brightness.b > 0) && fit.greatest > 0;
      const double most = fit.greatest + slack + slack_steps * std::abs(fit.per_step);
      if (cosine && is_seen) lights.push_back({*cosine, brightness, fit.greatest, most});
    }
    if (lights.empty()) out_.plain(Opcode::set_constant, field_, {}, ambient);
    for (std::size_t i = 0; i < lights.size(); ++i) add(lights[i], i == 0 ? std::optional(ambient) : std::nullopt);
  }

 private:
  /// A light that reaches the facet.
  struct Light {
    ScaledCosine cosine;
    glm::dvec3 brightness;  ///< brightness of the light's colour on the surface
    double greatest;        ///< maximum of the fitted cosine on the facet
    double most;            ///< upper bound of the cosine that pixels compute, with the error of fit and rounding
  };

  /// Adds a light. `begun` is the value to start from, if the field does not hold it yet.
  void add(const Light& light, const std::optional<std::uint32_t>& begun) {
    out_.plain(Opcode::enable_store, context_.layout.kept);
    emit_cosine(light.cosine);
    const std::array<Field, 3> channels = colour_channels(field_);
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const Field channel = channels.at(i);
      if (channel.width == 0) continue;
      const unsigned place = channel.base - field_.base;
      const auto level = begun ? std::optional(*begun >> place & ((1U << channel.width) - 1)) : std::nullopt;
      add_in_parts(channel, level, light, static_cast<glm::length_t>(i));
    }
    brightest_ = glm::min(brightest_ + light.brightness * light.most, 1.0);
  }

  /// Adds the light in several parts if the sum would overflow; each part saturates the channel.
  void add_in_parts(Field channel, std::optional<std::uint32_t> begun, const Light& light, glm::length_t c) {
    double before = brightest_[c];
    int parts = 1;
    const auto brightness = [&] { return light.brightness[c] / parts; };
    const auto brightest = [&] { return before + brightness() * light.most; };
    while (max_sum(channel, brightest()) >= std::ldexp(1.0, sum_.width)) ++parts;
    for (int part = 0; part < parts; ++part) {
      add_to({channel, part == 0 ? begun : std::nullopt, brightness(), brightest(), light.greatest}, light.cosine.one);
      before = std::min(brightest(), 1.0);
    }
  }

  /// cosine_ := the cosine, or 0 where it is negative (the surface faces away from the light).
  void emit_cosine(const ScaledCosine& cosine) {
    const Layout& layout = context_.layout;
    const Field z1 = layout.light == layout.candidate ? layout.depth : layout.candidate;
    const unsigned taken = cosine.has_depth ? std::min<unsigned>(cosine_.width, z1.width - cosine.drop) : 0;
    if (taken > 0) out_.plain(Opcode::copy, subfield(cosine_, 0, taken), subfield(z1, cosine.drop, taken));
    if (taken < cosine_.width) out_.plain(Opcode::set_constant, subfield(cosine_, taken, cosine_.width - taken));
    out_.expression(cosine.is_minus ? Opcode::linear_minus : Opcode::linear_plus, cosine_, cosine.plane, fraction_bits,
                    pixels_);
    out_.plain(Opcode::enable_and, subfield(cosine_, cosine_.width - 1U, 1));
    out_.plain(Opcode::set_constant, cosine_);
    out_.plain(Opcode::enable_load, context_.layout.kept);
  }

  /// A channel and the light to add to it.
  struct Channel {
    Field field;
    std::optional<std::uint32_t> begun;  ///< value to start from, if the field does not hold it yet
    double brightness;
    double brightest;  ///< upper bound after the addition, 1 is full scale
    double greatest;   ///< maximum of the fitted cosine on the facet
  };

  static double full_scale(Field channel) { return std::ldexp(1.0, channel.width) - 1; }

  /// Upper bound of a sum for a channel, in levels.
  static double max_sum(Field channel, double brightest) { return full_scale(channel) * brightest + 2; }

  /// channel += brightness * cosine, saturated at the channel's maximum.
  void add_to(const Channel& channel, double one) {
    const double most = max_sum(channel.field, channel.brightest);
    unsigned fraction = max_sum_fraction;
    while (fraction > 0 && most >= std::ldexp(1.0, static_cast<int>(sum_.width - fraction))) --fraction;
    const unsigned needed = std::min<unsigned>(static_cast<unsigned>(std::ilogb(most)) + 1 + fraction, sum_.width);
    const Field sum = subfield(sum_, 0, needed);
    const Multiple multiple = cosine_multiple(channel, one, fraction);
    if (multiple.digits.plus.empty()) {
      if (channel.begun) out_.plain(Opcode::set_constant, channel.field, {}, *channel.begun);
      return;
    }
    emit_sum(channel, sum, fraction, multiple);
    const unsigned held = held_bits(channel, sum, fraction);
    out_.plain(Opcode::copy, subfield(channel.field, 0, held), subfield(sum, fraction, held));
    if (held < channel.field.width)
      out_.plain(Opcode::set_constant, subfield(channel.field, held, channel.field.width - held));
    for (unsigned bit = fraction + channel.field.width; bit < sum.width; ++bit) {
      if (most < std::ldexp(1.0, static_cast<int>(bit - fraction))) break;
      out_.plain(Opcode::enable_and, subfield(sum, bit, 1));
      out_.plain(Opcode::set_constant, channel.field, {}, static_cast<std::uint64_t>(full_scale(channel.field)));
      out_.plain(Opcode::enable_load, context_.layout.kept);
    }
  }

  /// A multiple of the cosine, in units of the sum.
  struct Multiple {
    Digits digits;
    double lost = 0;  ///< added back: half of the rest at the greatest cosine, and half a unit for each truncated digit
  };

  /// The error is within half a level of light after `lost` is added back.
  Multiple cosine_multiple(const Channel& channel, double one, unsigned fraction) const {
    const double level = std::ldexp(1.0, static_cast<int>(fraction));
    const double greatest = channel.greatest * one;
    Multiple multiple{fewest_digits(level * full_scale(channel.field) * channel.brightness / one, level / greatest)};
    const auto cut = [](int exponent) { return exponent < 0; };
    const auto half = [&](const std::vector<int>& digits) {
      return 0.5 * static_cast<double>(std::count_if(digits.begin(), digits.end(), cut));
    };
    multiple.lost = multiple.digits.rest * greatest / 2 + half(multiple.digits.plus) - half(multiple.digits.minus);
    return multiple;
  }

  /// sum := the channel plus the multiple.
  void emit_sum(const Channel& channel, Field sum, unsigned fraction, const Multiple& multiple) {
    const double level = std::ldexp(1.0, static_cast<int>(fraction));
    // Copying the sum back truncates half a level on average.
    const auto more = std::lround(std::max(level / 2 + multiple.lost, 0.0));
    auto next = multiple.digits.plus.begin();
    if (!channel.begun) {
      begin_sum(channel, sum, fraction, static_cast<std::uint64_t>(more));
    } else {
      copy_shifted(sum, *next++);
      out_.expression(Opcode::linear_plus, sum, {0, 0, (std::int64_t{*channel.begun} << fraction) + more}, 0, pixels_);
    }
    for (; next != multiple.digits.plus.end(); ++next) add_shifted(sum, *next);
    if (multiple.digits.minus.empty()) return;
    // The sum is complemented before and after, which turns additions into subtractions.
    const std::uint64_t all = (std::uint64_t{1} << sum.width) - 1;
    out_.plain(Opcode::xor_constant, sum, {}, all);
    for (const int exponent : multiple.digits.minus) add_shifted(sum, exponent);
    out_.plain(Opcode::xor_constant, sum, {}, all);
  }

  /// sum := the channel, plus `more` as far as the sum's fraction holds it.
  void begin_sum(const Channel& channel, Field sum, unsigned fraction, std::uint64_t more) {
    const unsigned held = held_bits(channel, sum, fraction);
    const unsigned end = fraction + held;
    if (fraction > 0)
      out_.plain(Opcode::set_constant, subfield(sum, 0, fraction), {},
                 std::min(more, (std::uint64_t{1} << fraction) - 1));
    out_.plain(Opcode::copy, subfield(sum, fraction, held), subfield(channel.field, 0, held));
    if (end < sum.width) out_.plain(Opcode::set_constant, subfield(sum, end, sum.width - end));
  }

  /// Number of the channel's bits that the sum holds; the bits above stay 0.
  static unsigned held_bits(const Channel& channel, Field sum, unsigned fraction) {
    return std::min<unsigned>(channel.field.width, sum.width - fraction);
  }

  /// A shifted part of the cosine, which is not negative, and its target bits in the sum.
  struct Shifted {
    Field target;  ///< up to the top of the sum
    Field source;  ///< width 0 if all bits are shifted out
  };

  [[nodiscard]] Shifted shifted(Field sum, int exponent) const {
    const unsigned up = std::min<unsigned>(exponent > 0 ? static_cast<unsigned>(exponent) : 0, sum.width);
    const unsigned magnitude = cosine_.width - 1U;
    const unsigned down = std::min(exponent < 0 ? static_cast<unsigned>(-exponent) : 0, magnitude);
    const Field target = subfield(sum, up, sum.width - up);
    return {target, subfield(cosine_, down, std::min<unsigned>(magnitude - down, target.width))};
  }

  void add_shifted(Field sum, int exponent) {
    const Shifted part = shifted(sum, exponent);
    if (part.source.width > 0) out_.plain(Opcode::add, part.target, part.source);
  }

  void copy_shifted(Field sum, int exponent) {
    const Shifted part = shifted(sum, exponent);
    const unsigned below = sum.width - part.target.width;
    const unsigned end = below + part.source.width;
    if (below > 0) out_.plain(Opcode::set_constant, subfield(sum, 0, below));
    if (part.source.width > 0) out_.plain(Opcode::copy, subfield(sum, below, part.source.width), part.source);
    if (end < sum.width) out_.plain(Opcode::set_constant, subfield(sum, end, sum.width - end));
  }

  const Context& context_;
  Broadcast& out_;
  const Facet& facet_;
  Field field_;
  const view::PixelRect& pixels_;
  const lighting::Finish& finish_;
  Field cosine_;
  Field sum_;
  glm::dvec3 brightest_{0};  ///< upper bound of the channels until now, 1 is full scale
};

}  // namespace

unsigned light_bits(unsigned colour_bits) { return 2 * (widest_channel(colour_bits) + more_bits); }

void emit_curved_light(const Context& context, Broadcast& out, const Facet& facet, Field field,
                       const view::PixelRect& pixels) {
  Painter(context, out, facet, field, pixels).paint();
}

}  // namespace csgsim::emit
