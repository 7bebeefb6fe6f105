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

/// What a machine is built of.
struct Resources {
  std::uint64_t processors = 0;
  std::uint64_t memory_bits = 0;  ///< of the processors, and of a frame buffer beside them
};

/// Parts of a picture that is subdivided (thesis 7.3.3, 7.4).
enum class Parts : std::uint8_t { segments, subsegments };

/// A kind of machine: all that is known of its machines without building them. Each has a room, hw/KIND, and a row in
/// hw/kinds. What a kind does not override, it does not have.
class Kind {
 public:
  using Machine = machines::Machine;
  using Program = isa::Program;
  using Told = machines::Told;
  using Timeline = machines::Timeline;
  using Spans = std::vector<ClockSpan>;

  constexpr Kind(std::string_view kind_name, std::span<const FigureSchema> figures)
      : name(kind_name), schema(figures) {}
  virtual ~Kind() = default;

  std::string_view name;  ///< as descriptions give it
  /// Every figure that a description has to give, besides its `name`, `description` and `kind`.
  std::span<const FigureSchema> schema;

  /// Gives the machine the kind's own figures, as they are before a description is read.
  virtual void give_figures(Machine& machine) const = 0;
  /// Works out what follows from the figures. Throws InputError where they do not fit each other.
  virtual void complete(Machine& /*machine*/) const {}
  /// Throws InputError where the machine cannot draw such a picture.
  virtual void set_picture(Machine& /*machine*/, Size /*size*/) const {}

  /// The field of pixel memory from which so many bits of colour are shown, where that is not the one in which they
  /// are drawn; else one of width 0.
  [[nodiscard]] virtual isa::Field second_buffer(std::uint32_t /*colour_bits*/, const Machine& /*machine*/) const {
    return {};
  }
  /// Whether the controller learns if any pixel is enabled.
  [[nodiscard]] virtual bool has_global_or(const Machine& /*machine*/) const { return false; }
  /// Whether its host keeps a list of what is active on a line, for which a Program has extents of rows.
  [[nodiscard]] virtual bool keeps_active_list() const { return false; }
  /// Of the picture, in the order in which the machine draws them.
  [[nodiscard]] virtual std::vector<isa::Region> regions(const Machine& machine) const = 0;
  /// Processors that share the host's work.
  [[nodiscard]] virtual std::uint32_t hosts(const Machine& machine) const { return machine.host.count; }
  /// Whether and how it divides the model itself.
  [[nodiscard]] virtual std::optional<Division> division(const Machine& /*machine*/) const { return std::nullopt; }
  /// The machine as it draws, part by part, a picture that is halved so many times into segments, or the subsegments of
  /// these; nothing from a kind that does not draw square by square.
  [[nodiscard]] virtual std::optional<Machine> subdivided(const Machine& /*machine*/, std::uint32_t /*levels*/,
                                                          Parts /*parts*/) const {
    return std::nullopt;
  }
  /// Throws InputError, which says what to do, where the machine cannot run the Program; what holds of all kinds has
  /// been checked.
  virtual void check(const Program& /*program*/, const Machine& /*machine*/) const {}

  /// Whether its clocks depend on which pixels are enabled (Told::met), which only a run tells.
  [[nodiscard]] virtual bool asks_for_pixels(const Machine& /*machine*/) const { return false; }
  /// Clocks that a pixel's processor, or a chain's entry, spends on an instruction, where it carries out all of it.
  [[nodiscard]] virtual std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) const = 0;
  /// On a segment's instruction of that number. `met`: of that segment; null where no run told, and all pixels are
  /// taken for enabled.
  [[nodiscard]] virtual PixelClocks clocks_at_pixels(const isa::Segment& segment, std::size_t index,
                                                     const Machine& machine, const MetPixels* /*met*/) const {
    const std::uint64_t pixels = std::uint64_t{segment.region.width} * segment.region.height;
    const std::uint64_t all = clocks(segment.instructions[index], machine) * pixels;
    return {all, all};
  }
  /// Worked out from these, without stepping.
  [[nodiscard]] virtual FrameTiming time(const Program& program, const Machine& machine, const Told& told) const = 0;
  /// When its instructions are carried out, from the same working-out; nothing from a kind that does not tell.
  [[nodiscard]] virtual std::optional<Timeline> timeline(const Program& /*program*/, const Machine& /*machine*/,
                                                         const Told& /*told*/) const {
    return std::nullopt;
  }
  /// As machines::at_pixel, of a timeline that it told.
  [[nodiscard]] virtual Spans at_pixel(const Timeline& /*timeline*/, const Program& /*program*/,
                                       const Machine& /*machine*/, std::uint32_t /*segment*/, std::uint32_t /*x*/,
                                       std::uint32_t /*y*/) const {
    return {};
  }
  [[nodiscard]] virtual Resources resources(const Machine& machine, const isa::FrameHeader& header) const = 0;
  /// Its parts, those that may bound a frame, with the clocks in which each works from one frame to the next; none from
  /// a kind that does not tell. Of several that are alike the one that works most.
  [[nodiscard]] virtual std::vector<Load> loads(const FrameTiming& /*timing*/) const { return {}; }
  /// Whether studies of several machines draw on it only where it is named: a frame is millions of commands.
  [[nodiscard]] virtual bool is_costly() const { return false; }
  /// Whether its processors are the pixels of hw/rtl, whose area is known (hw/machines/area.h).
  [[nodiscard]] virtual bool bit_serial_pixels() const { return false; }
};

/// What a kind is derived from: its machines have Figures of its own.
template <class Figures>
class KindOf : public Kind {
 public:
  using Kind::Kind;

  void give_figures(Machine& machine) const final { machine.own = Figures{}; }

 protected:
  static const Figures& figures_of(const Machine& machine) { return own<Figures>(machine); }
};

}  // namespace csgsim::machines
