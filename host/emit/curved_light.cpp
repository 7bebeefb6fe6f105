#include "host/emit/curved_light.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <vector>

#include "host/emit/fields.h"
#include "host/emit/light_fit.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Field;
using isa::Opcode;

/// Bits of a cosine, and of the sum that becomes a channel, beyond those of the widest channel: a cosine has a sign and
/// goes to twice 1; a sum has a fraction, and room for what is too bright.
constexpr unsigned more_bits = 3;

/// Fraction bits of the expressions of cosines.
constexpr unsigned fraction_bits = 8;

/// Fraction bits of the sum, if it is not too bright for them.
constexpr unsigned most_sum_fraction = 2;

/// By which a fitted cosine may be more than what it comes to at the places that it was fitted to.
constexpr double slack = 0.1;

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

/// The unit is such that a step of depth is a power of two of it, and 1 is from `least_one` to twice that many.
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
  // Of a sum of two floors the half that each loses comes back; of a difference they cancel.
  const double lost = !cosine.has_depth ? 0.5 : cosine.is_minus ? 0.0 : 1.0;
  const view::RealLinear plane{fit.plane.a * cosine.one, fit.plane.b * cosine.one, fit.plane.at_centre * cosine.one + lost};
  const auto fixed = view::to_fixed(plane, fraction_bits, sampling.width, sampling.height);
  if (!fixed) return std::nullopt;
  cosine.plane = *fixed;
  return cosine;
}

/// A number as a sum and difference of powers of two, from the greatest down.
struct Digits {
  std::vector<int> plus;   ///< exponents
  std::vector<int> minus;  ///< exponents
};

/// Binary digits: as few as leave an error of at most `error`.
Digits binary(double value, double error) {
  Digits digits;
  while (value > error) {
    const int exponent = std::ilogb(value);
    digits.plus.push_back(exponent);
    value -= std::ldexp(1.0, exponent);
  }
  return digits;
}

/// Digits of both signs, nearest power first.
Digits both_signs(double value, double error) {
  Digits digits;
  while (std::abs(value) > error) {
    const int exponent = static_cast<int>(std::lround(std::log2(std::abs(value))));
    (value > 0 ? digits.plus : digits.minus).push_back(exponent);
    value -= std::copysign(std::ldexp(1.0, exponent), value);
  }
  return digits;
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
    cosine_ = part_of(context.layout.light, 0, bits);
    sum_ = part_of(context.layout.light, bits, bits);
  }

  void paint() {
    brightest_ = finish_.colour * context_.lighting().ambient * finish_.material.ambient;
    const std::uint32_t ambient = packed(brightest_, field_.width);
    std::vector<Light> lights;
    for (const lighting::SeenLight& light : context_.lighting().lights) {
      const LightFit fit = fit_light(context_, facet_, light);
      const glm::dvec3 brightness = finish_.colour * light.colour * finish_.material.diffuse;
      const auto cosine = scaled(fit, std::ldexp(1.0, static_cast<int>(cosine_.width) - 3), context_.view.sampling);
      const bool is_seen = (brightness.r > 0 || brightness.g > 0 || brightness.b > 0) && fit.greatest > 0;
      if (cosine && is_seen) lights.push_back({*cosine, brightness, fit.greatest});
    }
    if (lights.empty()) out_.plain(Opcode::set_constant, field_, {}, ambient);
    for (std::size_t i = 0; i < lights.size(); ++i) add(lights[i], i == 0 ? std::optional(ambient) : std::nullopt);
  }

 private:
  /// A light that reaches the facet.
  struct Light {
    ScaledCosine cosine;
    glm::dvec3 brightness;  ///< of its colour on the surface
    double greatest;        ///< cosine
  };

  /// `begun`: what the field would hold, if it is to be taken as that.
  void add(const Light& light, const std::optional<std::uint32_t>& begun) {
    out_.plain(Opcode::enable_store, context_.layout.kept);
    emit_cosine(light.cosine);
    const std::array<Field, 3> channels = channels_of(field_);
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const Field channel = channels.at(i);
      if (channel.width == 0) continue;
      const auto c = static_cast<glm::length_t>(i);
      const double brightest = brightest_[c] + light.brightness[c] * (light.greatest + slack);
      const unsigned place = channel.base - field_.base;
      add_to({channel, begun ? std::optional(*begun >> place & ((1U << channel.width) - 1)) : std::nullopt,
              light.brightness[c], brightest},
             light.cosine.one);
    }
    brightest_ = glm::min(brightest_ + light.brightness * light.greatest, 1.0);
  }

  /// Where it is below 0 there is no light.
  void emit_cosine(const ScaledCosine& cosine) {
    const Layout& layout = context_.layout;
    const Field z1 = layout.light == layout.candidate ? layout.depth : layout.candidate;
    const unsigned taken = cosine.has_depth ? std::min<unsigned>(cosine_.width, z1.width - cosine.drop) : 0;
    if (taken > 0) out_.plain(Opcode::copy, part_of(cosine_, 0, taken), part_of(z1, cosine.drop, taken));
    if (taken < cosine_.width) out_.plain(Opcode::set_constant, part_of(cosine_, taken, cosine_.width - taken));
    out_.expression(cosine.is_minus ? Opcode::linear_minus : Opcode::linear_plus, cosine_, cosine.plane, fraction_bits, pixels_);
    out_.plain(Opcode::enable_and, part_of(cosine_, cosine_.width - 1U, 1));
    out_.plain(Opcode::set_constant, cosine_);
    out_.plain(Opcode::enable_load, context_.layout.kept);
  }

  /// What becomes of a channel.
  struct Channel {
    Field field;
    std::optional<std::uint32_t> begun;  ///< what it would hold, if it is to be taken as that
    double brightness;
    double brightest;  ///< that it comes to, of 1
  };

  /// channel += brightness * cosine, but no more than it holds.
  void add_to(const Channel& channel, double one) {
    const double top = std::ldexp(1.0, static_cast<int>(channel.field.width)) - 1;
    const double most = top * channel.brightest + 1;
    unsigned fraction = most_sum_fraction;
    while (fraction > 0 && most >= std::ldexp(1.0, static_cast<int>(sum_.width - fraction))) --fraction;
    begin_sum(channel, fraction);
    add_times(std::ldexp(top * channel.brightness / one, static_cast<int>(fraction)), fraction);
    out_.plain(Opcode::copy, channel.field, part_of(sum_, fraction, channel.field.width));
    for (unsigned bit = fraction + channel.field.width; bit < sum_.width; ++bit) {
      if (most < std::ldexp(1.0, static_cast<int>(bit - fraction))) break;
      out_.plain(Opcode::enable_and, part_of(sum_, bit, 1));
      out_.plain(Opcode::set_constant, channel.field, {}, static_cast<std::uint64_t>(top));
      out_.plain(Opcode::enable_load, context_.layout.kept);
    }
  }

  /// The channel, and the half that copying it back will lose.
  void begin_sum(const Channel& channel, unsigned fraction) {
    const std::uint64_t half = (std::uint64_t{1} << fraction) >> 1U;
    if (channel.begun) {
      out_.plain(Opcode::set_constant, sum_, {}, (std::uint64_t{*channel.begun} << fraction) + half);
      return;
    }
    if (fraction > 0) out_.plain(Opcode::set_constant, part_of(sum_, 0, fraction), {}, half);
    const unsigned end = fraction + channel.field.width;
    out_.plain(Opcode::copy, part_of(sum_, fraction, channel.field.width), channel.field);
    out_.plain(Opcode::set_constant, part_of(sum_, end, sum_.width - end));
  }

  /// sum += factor * cosine, within half a level of light at the brightest.
  void add_times(double factor, unsigned fraction) {
    const double error = std::ldexp(0.5, static_cast<int>(fraction)) / std::ldexp(1.0, static_cast<int>(cosine_.width) - 2);
    const Digits plain = binary(factor, error);
    const Digits both = both_signs(factor, error);
    // To subtract, the sum is complemented before and after: as dear as one addition.
    const std::size_t turning = both.minus.empty() ? 0 : 1;
    const Digits& digits = both.plus.size() + both.minus.size() + turning < plain.plus.size() ? both : plain;
    for (const int exponent : digits.plus) add_shifted(exponent);
    if (digits.minus.empty()) return;
    const std::uint64_t all = (std::uint64_t{1} << sum_.width) - 1;
    out_.plain(Opcode::xor_constant, sum_, {}, all);
    for (const int exponent : digits.minus) add_shifted(exponent);
    out_.plain(Opcode::xor_constant, sum_, {}, all);
  }

  void add_shifted(int exponent) {
    const unsigned up = exponent > 0 ? static_cast<unsigned>(exponent) : 0;
    const unsigned down = exponent < 0 ? static_cast<unsigned>(-exponent) : 0;
    const unsigned magnitude = cosine_.width - 1U;
    if (up >= sum_.width || down >= magnitude) return;
    const Field target = part_of(sum_, up, sum_.width - up);
    out_.plain(Opcode::add, target, part_of(cosine_, down, std::min<unsigned>(magnitude - down, target.width)));
  }

  const Context& context_;
  Broadcast& out_;
  const Facet& facet_;
  Field field_;
  const view::PixelRect& pixels_;
  const lighting::Finish& finish_;
  Field cosine_;
  Field sum_;
  glm::dvec3 brightest_{0};  ///< what the channels come to so far, of 1
};

}  // namespace

unsigned light_bits(unsigned colour_bits) { return 2 * (widest_channel(colour_bits) + more_bits); }

void emit_curved_light(const Context& context, Broadcast& out, const Facet& facet, Field field,
                       const view::PixelRect& pixels) {
  Painter(context, out, facet, field, pixels).paint();
}

}  // namespace csgsim::emit
