#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "host/effects/blend.h"
#include "host/effects/rows.h"
#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

using isa::Opcode;

struct CueSettings {
  std::optional<double> near;
  std::optional<double> far;
  std::optional<glm::dvec3> colour;
  unsigned bits = 5;
};

void visit_keys(CueSettings& settings, auto&& visit) {
  visit(scene::number_key("near", "model units", -scene::coordinate_limit, scene::coordinate_limit,
                          "distance from the eye at which colours start to fade; by default the nearest depth"),
        settings.near);
  visit(scene::number_key("far", "model units", -scene::coordinate_limit, scene::coordinate_limit,
                          "distance at which colours have faded completely; by default the farthest depth"),
        settings.far);
  visit(scene::colour_key("colour", "colour to fade into; by default the background's"), settings.colour);
  visit(scene::integer_key("bits", "bits", 1, 6, "resolution of the fading: 2^bits steps"), settings.bits);
}

/// Depths in unrounded steps between which colours fade.
struct Fading : emit::EffectState {
  double begin = 0;
  double end = 0;
};

/// Fades the colours at the pixels of the drawing.
class Fader {
 public:
  Fader(const emit::Context& context, emit::Broadcast& out, const Fading& fading, unsigned bits)
      : context_(context), fading_(fading), out_(out), bits_(bits), faded_(context_.layout.of("depth_cue", "faded")) {}

  void fade(std::uint32_t cue) {
    out_.origin = emit::effect_origin;
    weigh();
    for (const isa::Field channel : colour_channels(context_.layout.colour))
      blend(channel,
            cue >> static_cast<unsigned>(channel.base - context_.layout.colour.base) & ((1U << channel.width) - 1));
  }

 private:
  /// Leaves E at 1 at depths of at least `step`.
  void from_depth(std::int64_t step) {
    out_.surface(Opcode::linear_le, context_.layout.depth, {0, 0, step << context_.view.sampling.fraction_bits},
                 context_.plan.pixels());
  }

  /// faded_ := the faded number of the 2^bits parts, rounded to nearest; 0 where nothing is visible.
  void weigh() {
    emit::enable_drawing(context_, out_);
    out_.plain(Opcode::set_constant, faded_, {}, 0);
    const std::uint64_t all = std::uint64_t{1} << bits_;
    for (std::uint64_t faded = 1; faded <= all; ++faded) {
      const double middle = (static_cast<double>(faded) - 0.5) / static_cast<double>(all);
      const double from = std::ceil(fading_.begin + middle * (fading_.end - fading_.begin));
      if (from >= static_cast<double>(context_.farthest())) break;
      const auto step = view::to_fixed(std::max(from, 0.0), 0);
      if (step && *step > 0) from_depth(*step);
      out_.plain(Opcode::set_constant, faded_, {}, faded);
    }
    from_depth(context_.farthest());
    out_.plain(Opcode::set_constant, faded_, {}, 0);
  }

  /// channel := ((2^bits - faded) * channel + faded * cue + half) / 2^bits. The channel's weight 2^bits - faded is
  /// computed as 1 + (2^bits - 1 - faded): one, plus the bits that are 0 in `faded`. The weight is 0 where the top bit
  /// of `faded` is 1.
  void blend(isa::Field channel, std::uint32_t level) {
    const isa::Field sum = subfield(context_.layout.of("depth_cue", "sum"), 0, channel.width + bits_);
    const auto from = [&](unsigned bit) { return subfield(sum, bit, sum.width - bit); };
    emit::enable_drawing(context_, out_);
    out_.plain(Opcode::set_constant, sum, {}, std::uint64_t{1} << (bits_ - 1));
    for (unsigned bit = 0; bit < channel.width; ++bit)
      if ((level >> bit & 1U) != 0) out_.plain(Opcode::add, from(bit), narrowed(faded_, sum.width - bit));
    out_.plain(Opcode::enable_and_not, subfield(faded_, bits_, 1));
    out_.plain(Opcode::add, sum, channel);
    for (unsigned bit = 0; bit < bits_; ++bit) {
      emit::enable_drawing(context_, out_);
      out_.plain(Opcode::enable_and_not, subfield(faded_, bits_, 1));
      out_.plain(Opcode::enable_and_not, subfield(faded_, bit, 1));
      out_.plain(Opcode::add, from(bit), channel);
    }
    emit::enable_drawing(context_, out_);
    out_.plain(Opcode::copy, channel, subfield(sum, bits_, channel.width));
  }

  static isa::Field narrowed(isa::Field field, unsigned width) {
    return subfield(field, 0, std::min<unsigned>(field.width, width));
  }

  const emit::Context& context_;
  const Fading& fading_;
  emit::Broadcast& out_;
  unsigned bits_;
  isa::Field faded_;
};

class DepthCue final : public emit::EffectOf<CueSettings, Fading> {
 public:
  [[nodiscard]] std::vector<emit::FieldRequest> fields(const emit::Drawing& /*drawing*/,
                                                       const emit::DrawingInputs& inputs) const override {
    const unsigned channel = isa::channel_widths(inputs.options.colour_bits)[1];
    return {{.name = "faded", .width = settings.bits + 1, .what = "faded part", .is_scratch = true},
            {.name = "sum", .width = channel + settings.bits, .what = "sum", .is_scratch = true}};
  }

  void finish(const emit::EffectCall& call, emit::Broadcast& out) const override {
    const emit::Options& options = call.context.options;
    const std::optional<glm::dvec3>& colour = settings.colour;
    const std::uint32_t cue = colour ? emit::packed_colour(*colour, options.colour_bits)
                                     : emit::packed_background(options.scene, options.colour_bits);
    Fader(call.context, out, prepared(call), settings.bits).fade(cue);
  }

 private:
  void prepare(State& state, const emit::Drawing& drawing, const emit::DrawingInputs& /*inputs*/) const override {
    const isa::DepthScale& scale = drawing.view.depth;
    const double near = settings.near.value_or(scale.near);
    const double far = settings.far.value_or(scale.far);
    if (scale.perspective && near <= 0)
      throw InputError(fmt::format("near = {:g} model units is behind the eye; set near above 0", near));
    if (!(far > near)) {
      throw InputError(
          fmt::format("colours cannot fade from {:g} to {:g} model units from the eye; set far above near", near, far));
    }
    const unsigned z_bits = drawing.view.sampling.z_bits;
    state.begin = isa::depth_of(scale, z_bits, near);
    state.end = isa::depth_of(scale, z_bits, far);
  }
};

}  // namespace

extern const emit::EffectRow depth_cue{
    .section = scene::effect_section<CueSettings>(
        "effects.depth_cue",
        "colours fade with depth: linearly with distance, or with its reciprocal in a perspective view"),
    .technique =
        "after all surfaces, the depth in pixel memory is compared with a constant for each step of fading, and "
        "channels are multiplied by shifting and adding, after Fuchs et al. 1985",
    .parts = emit::parts_of<DepthCue>,
    .takes_quadrics = true};

}  // namespace csgsim::effects
