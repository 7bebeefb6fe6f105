#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "host/effects/blend.h"
#include "host/effects/rows.h"
#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/regions.h"

namespace csgsim::effects {

namespace {

using isa::Opcode;

struct Settings {
  std::int64_t samples = 16;
  std::int64_t reach = 0;
};

constexpr std::int64_t max_samples = 64;

void visit_keys(Settings& settings, auto&& visit) {
  visit(scene::integer_key("samples", "per side", 1, max_samples,
                           "size of the lattice of pixels whose levels are counted"),
        settings.samples);
  visit(scene::integer_key("reach", "pixels", 0, isa::max_array_side,
                           "reach of a sample in all four directions; 0: the whole picture"),
        settings.reach);
}

/// Bits of a count of samples, and one more bit for the division.
unsigned count_bits(const Settings& settings) {
  return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(settings.samples * settings.samples))) + 1;
}

/// Bits of the widest possible channel.
constexpr unsigned max_level_bits = isa::channel_widths(isa::max_colour_bits)[1];

/// Equalises one picture, one channel after another.
class Equaliser {
 public:
  Equaliser(const emit::Context& context, emit::Broadcast& out, const Settings& settings)
      : context_(context),
        out_(out),
        settings_(settings),
        rank_(context_.layout.of("equalise", "rank")),
        seen_(context_.layout.of("equalise", "seen")),
        counted_(context_.layout.of("equalise", "counted")),
        // The mask is free while no surfaces are drawn.
        sample_(context_.layout.mask) {}

  void emit() {
    out_.origin = emit::effect_origin;
    const std::vector<view::PixelRect> samples = lattice();
    if (samples.empty()) return;
    out_.plain(Opcode::enable_all);
    out_.equals(context_.layout.depth, static_cast<std::uint32_t>(context_.farthest()));
    out_.plain(Opcode::enable_invert);
    out_.plain(Opcode::enable_store, seen_);
    out_.plain(Opcode::enable_all);
    out_.plain(Opcode::set_constant, counted_, {}, 0);
    bool is_first = true;
    for (const isa::Field channel : colour_channels(context_.layout.colour)) {
      emit_channel(channel, samples, is_first);
      is_first = false;
    }
  }

 private:
  /// The pixels of the lattice at which some primitive may be visible.
  [[nodiscard]] std::vector<view::PixelRect> lattice() const {
    std::vector<view::PixelRect> pixels;
    const auto place = [&](std::int64_t i, std::uint32_t side) {
      return static_cast<std::int32_t>((2 * i + 1) * side / (2 * settings_.samples));
    };
    for (std::int64_t row = 0; row < settings_.samples; ++row) {
      for (std::int64_t column = 0; column < settings_.samples; ++column) {
        const std::int32_t x = place(column, context_.view.sampling.width);
        const std::int32_t y = place(row, context_.view.sampling.height);
        if (may_be_seen({x, y, x, y})) pixels.push_back({x, y, x, y});
      }
    }
    return pixels;
  }

  [[nodiscard]] bool may_be_seen(const view::PixelRect& pixel) const {
    // The plan does not include what other cameras see, so it is used only if there are none.
    const bool is_alone = std::none_of(context_.called.begin(), context_.called.end(),
                                       [](const emit::EffectRequest& one) { return one.row->parts.draws_around; });
    const std::vector<emit::PlannedSurface>& surfaces = context_.plan.surfaces;
    return !is_alone || std::any_of(surfaces.begin(), surfaces.end(), [&](const emit::PlannedSurface& one) {
      return !view::common(one.block.pixels, pixel).empty();
    });
  }

  void emit_channel(isa::Field level, const std::vector<view::PixelRect>& samples, bool counts_samples) {
    const isa::Field reference = subfield(rank_, 0, level.width);
    const isa::Field rank = subfield(rank_, level.width, counted_.width);
    out_.plain(Opcode::enable_all);
    out_.plain(Opcode::set_constant, rank, {}, 0);
    for (const view::PixelRect& sample : samples) {
      out_.plain(Opcode::enable_load, seen_);
      out_.clip(sample, context_.plan.pixels());
      const std::size_t begin = out_.size();
      spread(level, reference);
      count(sample, reference, level, rank, counts_samples);
      skip_if_none(begin);
    }
    scale(level);
  }

  /// Copies the level of the enabled pixel to all pixels, bit by bit.
  void spread(isa::Field level, isa::Field reference) {
    out_.plain(Opcode::enable_store, sample_);
    out_.plain(Opcode::enable_all);
    out_.plain(Opcode::set_constant, reference, {}, 0);
    for (unsigned bit = 0; bit < level.width; ++bit) {
      out_.plain(Opcode::enable_load, sample_);
      out_.plain(Opcode::enable_and, subfield(level, bit, 1));
      const std::size_t begin = out_.size();
      out_.plain(Opcode::enable_all);
      out_.plain(Opcode::set_constant, subfield(reference, bit, 1), {}, 1);
      skip_if_none(begin);
    }
  }

  /// Increments the rank of the pixels within the sample's reach whose level is above the sample's level.
  void count(const view::PixelRect& sample, isa::Field reference, isa::Field level, isa::Field rank,
             bool counts_samples) {
    out_.plain(Opcode::enable_all);
    if (settings_.reach > 0) {
      const auto reach = static_cast<std::int32_t>(settings_.reach);
      const view::PixelRect all = context_.plan.pixels();
      out_.clip(view::common(all, {sample.x0 - reach, sample.y0 - reach, sample.x1 + reach, sample.y1 + reach}), all);
    }
    if (counts_samples) {
      out_.plain(Opcode::enable_store, sample_);
      out_.plain(Opcode::add, counted_, sample_);
    }
    out_.plain(Opcode::field_lt, reference, level);
    out_.plain(Opcode::enable_store, sample_);
    out_.plain(Opcode::add, rank, sample_);
  }

  void skip_if_none(std::size_t begin) {
    out_.insert(begin, {Opcode::skip_if_none, {}, {}, out_.size() - begin, out_.origin});
  }

  /// level := 2^width * rank / counted, or all ones if that is too large. Long division: rank and remainder are shifted
  /// up one bit at a time, and zeros are shifted in.
  void scale(isa::Field level) {
    out_.plain(Opcode::enable_all);
    out_.equals(counted_, 0);
    out_.plain(Opcode::enable_invert);
    out_.plain(Opcode::enable_and, seen_);
    out_.plain(Opcode::enable_store, sample_);
    out_.plain(Opcode::set_constant, level, {}, 0);
    out_.plain(Opcode::set_constant, subfield(rank_, 0, level.width), {}, 0);
    for (unsigned bit = level.width; bit-- > 0;) {
      const isa::Field rest = subfield(rank_, bit, counted_.width);
      out_.plain(Opcode::enable_load, sample_);
      out_.plain(Opcode::field_le, counted_, rest);
      // Uses a - b = not (not a + b).
      out_.plain(Opcode::bit_not, rest, rest);
      out_.plain(Opcode::add, rest, counted_);
      out_.plain(Opcode::bit_not, rest, rest);
      out_.plain(Opcode::set_constant, subfield(level, bit, 1), {}, 1);
    }
  }

  const emit::Context& context_;
  emit::Broadcast& out_;
  const Settings& settings_;
  isa::Field rank_;     ///< rank; the bits below it hold the sample's level
  isa::Field seen_;     ///< 1 where any primitive is visible
  isa::Field counted_;  ///< number of samples that reach the pixel
  isa::Field sample_;   ///< 1 at the sample; also the increment of a count
};

class Equalise final : public emit::EffectOf<Settings> {
 public:
  [[nodiscard]] std::vector<emit::FieldRequest> fields(const emit::Drawing& /*drawing*/,
                                                       const emit::DrawingInputs& /*inputs*/) const override {
    const unsigned count = count_bits(settings);
    return {{.name = "rank", .width = max_level_bits + count, .what = "rank", .is_scratch = true},
            {.name = "seen", .width = 1, .what = "seen", .is_scratch = true},
            {.name = "counted", .width = count, .what = "count", .is_scratch = true}};
  }

  void enhance(const emit::EffectCall& call, emit::Broadcast& out) const override {
    Equaliser(call.context, out, settings).emit();
  }

 private:
  void prepare(State& /*state*/, const emit::Drawing& /*drawing*/, const emit::DrawingInputs& inputs) const override {
    const machines::Machine& machine = inputs.machine;
    if (!machines::has_global_or(machine) || machines::regions(machine).size() > 1) {
      throw InputError(fmt::format(
          "the effect equalise reads levels of pixels with a global OR over the whole picture, which {} does "
          "not have; use a machine that has one, such as pixel-planes-4, or leave the effect out by --set "
          "effects.equalise.on=false",
          machine.name));
    }
  }
};

}  // namespace

extern const emit::EffectRow equalise{
    .section = scene::effect_section<Settings>(
        "effects.equalise",
        "where something is visible, each channel's level becomes its rank among those of a lattice of pixels"),
    .technique =
        "Fuchs et al. 1985: adaptive histogram equalisation by broadcasting levels, with which every pixel "
        "compares its own; here the levels of a lattice of pixels, read bit by bit with the global OR",
    .parts = emit::parts_of<Equalise>,
    .takes_quadrics = true};

}  // namespace csgsim::effects
