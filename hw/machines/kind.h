// Interface of all kinds of machines.
// Used by hw and sim.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/load.h"
#include "hw/machines/machine.h"
#include "hw/machines/regions.h"
#include "hw/machines/schema.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"

namespace csgsim::machines {

/// Hardware resources of a machine.
struct Resources {
  std::uint64_t processors = 0;
  std::uint64_t memory_bits = 0;  ///< memory of the processors and of a separate frame buffer
};

/// Units of a subdivided picture (thesis 7.3.3, 7.4).
enum class Parts : std::uint8_t { segments, subsegments };

/// A kind of machine: everything about its machines that does not need their simulation model. Each kind has a room,
/// hw/KIND, and a row in hw/kinds. A kind overrides the functions of the features that it has.
class Kind {
 public:
  using Machine = machines::Machine;
  using Program = isa::Program;
  using RunOutcome = machines::RunOutcome;
  using Timeline = machines::Timeline;
  using Spans = std::vector<ClockSpan>;

  constexpr Kind(std::string_view kind_name, std::span<const FigureSchema> figures)
      : name(kind_name), schema(figures) {}
  virtual ~Kind() = default;

  std::string_view name;  ///< value of `kind` in descriptions
  /// The parameters that a description must contain, in addition to `name`, `description` and `kind`.
  std::span<const FigureSchema> schema;

  /// Gives the machine the kind's own parameters with their default values.
  virtual void init_own_figures(Machine& machine) const = 0;
  /// Computes values that follow from the parameters. Throws InputError if the parameters are inconsistent.
  virtual void complete(Machine& /*machine*/) const {}
  /// Throws InputError if the machine cannot draw a picture of that size.
  virtual void set_picture(Machine& /*machine*/, Size /*size*/) const {}

  /// The field of pixel memory from which `colour_bits` bits of colour are displayed, if the machine draws them in
  /// another field; otherwise its width is 0.
  [[nodiscard]] virtual isa::Field second_buffer(std::uint32_t /*colour_bits*/, const Machine& /*machine*/) const {
    return {};
  }
  /// Whether the controller can test if any pixel is enabled.
  [[nodiscard]] virtual bool has_global_or(const Machine& /*machine*/) const { return false; }
  /// Whether the host keeps an active list per line, for which a Program has row extents.
  [[nodiscard]] virtual bool keeps_active_list() const { return false; }
  /// The regions of the picture, in the order in which the machine draws them.
  [[nodiscard]] virtual std::vector<isa::Region> regions(const Machine& machine) const = 0;
  /// Number of processors that share the host's work.
  [[nodiscard]] virtual std::uint32_t host_processor_count(const Machine& machine) const { return machine.host.count; }
  /// How the machine divides the model; empty if the host divides it.
  [[nodiscard]] virtual std::optional<Division> division(const Machine& /*machine*/) const { return std::nullopt; }
  /// A copy of the machine that draws a picture part by part. The picture is halved `levels` times into segments; the
  /// parts are these segments or their subsegments. Empty for a kind that does not draw in squares.
  [[nodiscard]] virtual std::optional<Machine> subdivided(const Machine& /*machine*/, std::uint32_t /*levels*/,
                                                          Parts /*parts*/) const {
    return std::nullopt;
  }
  /// Throws InputError, with advice, if the machine cannot run the Program. Rules common to all kinds have already been
  /// checked.
  virtual void check(const Program& /*program*/, const Machine& /*machine*/) const {}

  /// Whether the clocks depend on which pixels are enabled (RunOutcome::pixel_activity), which only a run determines.
  [[nodiscard]] virtual bool depends_on_pixels(const Machine& /*machine*/) const { return false; }
  /// Clocks that a pixel's processor, or the entry of a chain, spends on an instruction if no part of it is skipped.
  [[nodiscard]] virtual std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const = 0;
  /// Clocks that instruction `index` of a segment takes, summed over the segment's pixels. `pixel_activity` is the
  /// measured activity in that segment; null without a run, in which case all pixels count as enabled.
  [[nodiscard]] virtual PixelClocks clocks_at_pixels(const isa::Segment& segment, std::size_t index,
                                                     const Machine& machine,
                                                     const PixelActivity* /*pixel_activity*/) const {
    const std::uint64_t pixels = std::uint64_t{segment.region.width} * segment.region.height;
    const std::uint64_t all = clocks(segment.instructions[index], machine) * pixels;
    return {all, all};
  }
  /// Timing of a frame, computed without stepping.
  [[nodiscard]] virtual FrameTiming time(const Program& program, const Machine& machine,
                                         const RunOutcome& outcome) const = 0;
  /// Clocks in which each instruction is executed, from the same computation as time(); empty for a kind that does not
  /// support this.
  [[nodiscard]] virtual std::optional<Timeline> timeline(const Program& /*program*/, const Machine& /*machine*/,
                                                         const RunOutcome& /*outcome*/) const {
    return std::nullopt;
  }
  /// Same as machines::spans_at_pixel(), for a timeline of this kind.
  [[nodiscard]] virtual Spans spans_at_pixel(const Timeline& /*timeline*/, const Program& /*program*/,
                                             const Machine& /*machine*/, std::uint32_t /*segment*/, std::uint32_t /*x*/,
                                             std::uint32_t /*y*/) const {
    return {};
  }
  [[nodiscard]] virtual Resources resources(const Machine& machine, const isa::FrameHeader& header) const = 0;
  /// Parts that may limit the frame rate, with the clocks per frame interval in which each of them works; empty for a
  /// kind that does not support this. Only the busiest of several equal parts is listed.
  [[nodiscard]] virtual std::vector<Load> loads(const FrameTiming& /*timing*/) const { return {}; }
  /// Whether studies of several machines include machines of this kind only if named, because a frame takes millions of
  /// commands.
  [[nodiscard]] virtual bool is_costly() const { return false; }
  /// Whether the processors are the pixels of hw/rtl, whose area is known (hw/machines/area.h).
  [[nodiscard]] virtual bool bit_serial_pixels() const { return false; }
};

/// Base class of kinds whose machines have their own Figures.
template <class Figures>
class KindOf : public Kind {
 public:
  using Kind::Kind;

  void init_own_figures(Machine& machine) const final { machine.own = Figures{}; }

 protected:
  static const Figures& figures_of(const Machine& machine) { return kind_figures<Figures>(machine); }
};

}  // namespace csgsim::machines
