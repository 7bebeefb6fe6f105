#include "host/effects/antialias.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <string>
#include <utility>

#include "host/effects/blend.h"
#include "host/effects/rows.h"
#include "host/emit/early_out.h"
#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/field_role.h"
#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

using isa::Opcode;

struct SampleSettings {
  std::int64_t samples = 4;
  bool adaptive = false;
  std::int64_t least_difference = 1;
};

constexpr double max_samples = 16;

void visit_keys(SampleSettings& settings, auto&& visit) {
  visit(scene::integer_key("samples", "samples per pixel", 2, max_samples, "2, 4, 8 or 16"), settings.samples);
  visit(scene::boolean_key("adaptive",
                           "start with a quarter of the samples, at least 2; double them at pixels where the means of "
                           "the two halves differ"),
        settings.adaptive);
  visit(scene::integer_key("least_difference", "levels of a channel", 1, 255,
                           "adaptive: means that differ by less are considered equal"),
        settings.least_difference);
}

void complete(const SampleSettings& settings) {
  const std::int64_t samples = settings.samples;
  if (!std::has_single_bit(static_cast<std::uint64_t>(samples)))
    throw InputError(fmt::format("{} samples per pixel cannot be averaged by a shift; use 2, 4, 8 or 16", samples));
}

bool is_shifted(const view::View& view) { return view.sampling.offset != glm::dvec2(0); }

constexpr std::array<std::string_view, 3> sum_names{"red", "green", "blue"};
constexpr std::array<std::string_view, 3> newer_names{"newer_red", "newer_green", "newer_blue"};

/// Adaptive sampling starts with at least two samples.
bool is_adaptive(const SampleSettings& settings) { return settings.adaptive && settings.samples > 2; }

unsigned log2_samples(const SampleSettings& settings) {
  return static_cast<unsigned>(std::countr_zero(static_cast<std::uint64_t>(settings.samples)));
}

/// A channel of the picture, with the fields that accumulate its samples.
struct Channel {
  isa::Field colour;
  isa::Field sum;    ///< sum of all samples
  isa::Field newer;  ///< sum of the samples that are not included in `sum` yet; width 0 if there is no such field
};

std::array<Channel, 3> channel_sums(const emit::Context& context, const SampleSettings& settings) {
  const std::array<isa::Field, 3> colours = colour_channels(context.layout.colour);
  std::array<Channel, 3> channels;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    channels[i] = {colours[i], context.layout.of("antialias", sum_names[i]), {}};
    if (is_adaptive(settings)) channels[i].newer = context.layout.of("antialias", newer_names[i]);
  }
  return channels;
}

/// Accumulates samples. All functions operate on the pixels where E is 1.
class Samples {
 public:
  Samples(const emit::Context& context, emit::Broadcast& out, const SampleSettings& settings)
      : context_(context), settings_(settings), out_(out), channels_(channel_sums(context, settings)) {}

  void clear(isa::Field Channel::*sum, std::uint64_t value) {
    for (const Channel& one : channels_) plain(Opcode::set_constant, one.*sum, {}, value);
  }

  /// Adds the picture to the sum.
  void add(isa::Field Channel::*sum) {
    for (const Channel& one : channels_) plain(Opcode::add, one.*sum, one.colour);
  }

  void add_newer() {
    for (const Channel& one : channels_) plain(Opcode::add, one.sum, one.newer);
  }

  /// Writes the sum divided by 2^shift to the picture.
  void divide(unsigned shift) {
    for (const Channel& one : channels_) plain(Opcode::copy, one.colour, subfield(one.sum, shift, one.colour.width));
  }

  /// Adds one half, so that the division by 2^shift rounds to nearest.
  void add_half(unsigned shift) {
    const isa::Field half = subfield(context_.layout.of("antialias", "more"), 0, shift);
    plain(Opcode::set_constant, half, {}, std::uint64_t{1} << (shift - 1));
    for (const Channel& one : channels_) plain(Opcode::add, one.sum, half);
  }

  /// Sets `bit` where the means of 2^shift samples, in the sum and in the newer samples, differ enough.
  void compare(unsigned shift, isa::Field bit) {
    plain(Opcode::enable_all);
    plain(Opcode::set_constant, bit, {}, 0);
    for (const Channel& one : channels_) {
      if (settings_.least_difference >= std::int64_t{1} << one.colour.width) continue;
      const unsigned width = one.colour.width + shift;
      is_less(subfield(one.sum, 0, width), subfield(one.newer, 0, width), shift, bit);
      is_less(subfield(one.newer, 0, width), subfield(one.sum, 0, width), shift, bit);
    }
  }

  void plain(Opcode opcode, isa::Field first = {}, isa::Field second = {}, std::uint64_t constant = 0) {
    out_.origin = emit::effect_origin;
    out_.plain(opcode, first, second, constant);
  }

 private:
  /// Sets the bit, at any pixel, where `less` + 2^shift least_difference <= `greater`.
  void is_less(isa::Field less, isa::Field greater, unsigned shift, isa::Field bit) {
    const isa::Field more = subfield(context_.layout.of("antialias", "more"), 0, less.width + 1U);
    const isa::Field other = subfield(context_.layout.of("antialias", "other"), 0, less.width + 1U);
    plain(Opcode::enable_all);
    plain(Opcode::set_constant, more, {}, static_cast<std::uint64_t>(settings_.least_difference) << shift);
    plain(Opcode::add, more, less);
    plain(Opcode::set_constant, other, {}, 0);
    plain(Opcode::add, other, greater);
    plain(Opcode::field_le, more, other);
    plain(Opcode::enable_or, bit);
    plain(Opcode::enable_store, bit);
  }

  const emit::Context& context_;
  const SampleSettings& settings_;
  emit::Broadcast& out_;
  std::array<Channel, 3> channels_;
};

/// Draws the picture without offset; its instructions are not charged to the effect.
void draw_centre(const emit::EffectCall& call, emit::Broadcast& out, const emit::DrawPicture& draw) {
  const std::uint8_t billed = std::exchange(out.effect, isa::no_effect);
  draw(call.context);
  out.effect = billed;
}

void draw_all(const emit::EffectCall& call, emit::Broadcast& out, const emit::DrawPicture& draw,
              const SampleSettings& settings) {
  Samples samples(call.context, out, settings);
  samples.plain(Opcode::enable_all);
  samples.clear(&Channel::sum, static_cast<std::uint64_t>(settings.samples / 2));
  for (const auto& drawing : call.state.drawings) {
    draw(emit::context_for(*drawing, call.context));
    samples.plain(Opcode::enable_all);
    samples.add(&Channel::sum);
  }
  // The unshifted picture is drawn last, so that its depths remain.
  draw_centre(call, out, draw);
  samples.plain(Opcode::enable_all);
  samples.add(&Channel::sum);
  samples.divide(log2_samples(settings));
}

/// Adds samples in steps, each at fewer pixels than the one before.
class Refinement {
 public:
  Refinement(const emit::EffectCall& call, emit::Broadcast& out, const emit::DrawPicture& draw,
             const SampleSettings& settings)
      : call_(call),
        out_(out),
        draw_(draw),
        settings_(settings),
        samples_(call.context, out, settings),
        refined_(call.context.layout.of("antialias", "refined")),
        differs_(call.context.layout.of("antialias", "differs")),
        layout_(call.context.layout) {
    // Preserves the depths of the unshifted picture.
    layout_.depth = layout_.of("antialias", "depth");
  }

  void draw() {
    const unsigned shift = std::max(1U, log2_samples(settings_) - 2);
    const std::size_t half = std::size_t{1} << (shift - 1);
    samples_.plain(Opcode::enable_all);
    samples_.clear(&Channel::sum, 0);
    samples_.clear(&Channel::newer, 0);
    for (std::size_t i = half; i < 2 * half; ++i) draw_whole(i, &Channel::sum);
    for (std::size_t i = 1; i < half; ++i) draw_whole(i, &Channel::newer);
    draw_centre(call_, out_, draw_);
    samples_.plain(Opcode::enable_all);
    samples_.add(&Channel::newer);
    samples_.compare(shift - 1, differs_);
    samples_.plain(Opcode::enable_all);
    samples_.add_newer();
    samples_.plain(Opcode::enable_store, refined_);
    finish(shift);
    refine(shift);
  }

 private:
  void draw_whole(std::size_t sample, isa::Field Channel::*sum) {
    draw_(emit::context_for(*call_.state.drawings[sample - 1], call_.context));
    samples_.plain(Opcode::enable_all);
    samples_.add(sum);
  }

  /// Finishes the pixels whose 2^shift samples do not differ.
  void finish(unsigned shift) {
    samples_.plain(Opcode::enable_load, refined_);
    samples_.plain(Opcode::enable_and_not, differs_);
    samples_.add_half(shift);
    samples_.divide(shift);
    samples_.plain(Opcode::enable_load, refined_);
    samples_.plain(Opcode::enable_and, differs_);
    samples_.plain(Opcode::enable_store, refined_);
  }

  /// Doubles the 2^shift samples at the pixels where `refined` is 1. E equals `refined`.
  void refine(unsigned shift) {
    const std::size_t begin = out_.size();
    const unsigned last = log2_samples(settings_);
    samples_.clear(&Channel::newer, 0);
    emit::Context elsewhere = emit::with_layout(call_.context, layout_);
    elsewhere.base = refined_;
    const std::size_t there = std::size_t{1} << shift;
    for (std::size_t i = there; i < 2 * there; ++i) {
      draw_(emit::context_for(*call_.state.drawings[i - 1], elsewhere));
      samples_.plain(Opcode::enable_load, refined_);
      samples_.add(&Channel::newer);
    }
    if (shift + 1 < last) samples_.compare(shift, differs_);
    samples_.plain(Opcode::enable_load, refined_);
    samples_.add_newer();
    if (shift + 1 < last) {
      finish(shift + 1);
      refine(shift + 1);
    } else {
      samples_.add_half(last);
      samples_.divide(last);
    }
    emit::emit_early_out(call_.context, out_, begin, emit::effect_origin);
  }

  const emit::EffectCall& call_;
  emit::Broadcast& out_;
  const emit::DrawPicture& draw_;
  const SampleSettings& settings_;
  Samples samples_;
  isa::Field refined_;
  isa::Field differs_;
  emit::Layout layout_;
};

class Antialias final : public emit::EffectOf<SampleSettings> {
 public:
  [[nodiscard]] std::vector<emit::FieldRequest> fields(const emit::Drawing& drawing,
                                                       const emit::DrawingInputs& inputs) const override {
    const std::array<unsigned, 3> widths = isa::channel_widths(inputs.options.colour_bits);
    const unsigned more = log2_samples(settings);
    std::vector<emit::FieldRequest> requests;
    const auto add = [&](std::string_view name, unsigned width, std::string_view what, std::string_view without) {
      requests.push_back({std::string(name), isa::FieldRole::effect, width, what, without});
    };
    for (std::size_t i = 0; i < sum_names.size(); ++i)
      add(sum_names[i], widths[i] + more, "sum of samples", "use --set effects.antialias.samples=2");
    if (!is_adaptive(settings)) return requests;
    constexpr std::string_view full = "use --set effects.antialias.adaptive=false";
    for (std::size_t i = 0; i < newer_names.size(); ++i)
      add(newer_names[i], widths[i] + more - 1, "sum of newer samples", full);
    add("refined", 1, "pixels to refine", full);
    add("differs", 1, "samples differ", full);
    add("depth", drawing.view.sampling.z_bits, "depth of samples", full);
    for (const std::string_view name : {"more", "other"})
      requests.push_back({std::string(name), isa::FieldRole::scratch, widths[1] + more, "", "", true});
    return requests;
  }

  bool draw_around(const emit::EffectCall& call, emit::Broadcast& out, const emit::DrawPicture& draw) const override {
    if (is_adaptive(settings)) {
      Refinement(call, out, draw, settings).draw();
    } else {
      draw_all(call, out, draw, settings);
    }
    return true;
  }

 private:
  void prepare(State& state, const emit::Drawing& drawing, const emit::DrawingInputs& inputs) const override {
    // Drawings of samples, and drawings inside a drawing, are not sampled again.
    if (drawing.nesting > 0 || is_shifted(drawing.view)) return;
    const auto count = static_cast<std::size_t>(settings.samples);
    for (const glm::dvec2& offset : sample_offsets(count)) {
      if (offset == glm::dvec2(0)) continue;
      state.drawings.push_back(emit::make_sample(drawing, offset, inputs));
    }
  }
};

/// Columns and rows in sixteenths of a pixel: a digital net (Sobol', USSR Computational Mathematics and Mathematical
/// Physics, 1967). Its first 2, 4 and 8 points are also nets, and their points are as far apart as possible.
constexpr std::array<std::array<int, 2>, 16> net{{{0, 0},
                                                  {12, 8},
                                                  {8, 4},
                                                  {4, 12},
                                                  {2, 11},
                                                  {14, 3},
                                                  {10, 15},
                                                  {6, 7},
                                                  {1, 14},
                                                  {13, 6},
                                                  {9, 10},
                                                  {5, 2},
                                                  {3, 5},
                                                  {15, 13},
                                                  {11, 1},
                                                  {7, 9}}};

}  // namespace

std::vector<glm::dvec2> sample_offsets(std::size_t count) {
  const auto wrapped = [](int part) { return (part < 8 ? part : part - 16) / 16.0; };
  std::vector<glm::dvec2> offsets;
  for (std::size_t i = 0; i < count; ++i) offsets.emplace_back(wrapped(net.at(i)[0]), wrapped(net.at(i)[1]));
  return offsets;
}

extern const emit::EffectRow antialias{
    .section = scene::effect_section<SampleSettings>("effects.antialias",
                                                     "smooth edges: the mean of several samples per pixel"),
    .technique =
        "successive refinement, Fuchs et al. 1985: the picture is drawn once per sample, moved by parts of a "
        "pixel, which changes only the constants C, and the colours are summed in pixel memory",
    .parts = emit::parts_of<Antialias>,
    .takes_quadrics = true};

}  // namespace csgsim::effects
