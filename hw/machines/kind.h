#pragma once

#include <any>
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
/// hw/kinds. Where a function may be null, there is nothing to do.
struct Kind {
  std::string_view name;  ///< as descriptions give it

  /// Every figure that a description has to give, besides its `name`, `description` and `kind`.
  std::span<const FigureSchema> schema;
  /// Its own figures before a description is read.
  std::any (*own)();
  /// Works out what follows from the figures. Throws InputError where they do not fit each other.
  void (*complete)(Machine& machine) = nullptr;
  /// Throws InputError where the machine cannot draw such a picture.
  void (*set_picture)(Machine& machine, Size size) = nullptr;

  /// The field of pixel memory from which so many bits of colour are shown, where that is not the one in which they
  /// are drawn; else one of width 0. Null for a kind that has no such field.
  isa::Field (*second_buffer)(std::uint32_t colour_bits, const Machine& machine) = nullptr;
  /// Whether the controller learns if any pixel is enabled; null for a kind whose controllers never do.
  bool (*has_global_or)(const Machine& machine) = nullptr;
  /// Whether its host keeps a list of what is active on a line, for which a Program has extents of rows.
  bool keeps_active_list = false;
  /// Of the picture, in the order in which the machine draws them.
  std::vector<isa::Region> (*regions)(const Machine& machine);
  /// Whether and how it divides the model itself; null for a kind that never does.
  std::optional<Division> (*division)(const Machine& machine) = nullptr;
  /// The machine as it draws, part by part, a picture that is halved so many times into segments, or the subsegments of
  /// these; null for a kind that does not draw square by square.
  Machine (*subdivided)(Machine machine, std::uint32_t levels, Parts parts) = nullptr;
  /// Throws InputError, which says what to do, where the machine cannot run the Program; what holds of all kinds has
  /// been checked.
  void (*check)(const isa::Program& program, const Machine& machine) = nullptr;

  /// Clocks that a pixel's processor, or a chain's entry, spends on an instruction.
  std::uint64_t (*clocks)(const isa::Instruction& instruction, const Machine& machine);
  /// Worked out from these, without stepping.
  FrameTiming (*time)(const isa::Program& program, const Machine& machine, std::span<const Skip> skips);
  /// When its instructions are carried out, from the same working-out; null for a kind that does not tell.
  Timeline (*timeline)(const isa::Program& program, const Machine& machine, std::span<const Skip> skips) = nullptr;
  /// As machines::at_pixel, of a timeline that it told.
  std::vector<ClockSpan> (*at_pixel)(const Timeline& timeline, const isa::Program& program, const Machine& machine,
                                     std::uint32_t segment, std::uint32_t x, std::uint32_t y) = nullptr;
  Resources (*resources)(const Machine& machine, const isa::FrameHeader& header);
  /// Its parts, those that may bound a frame, with the clocks in which each works from one frame to the next; null for
  /// a kind that does not tell. Of several that are alike the one that works most.
  std::vector<Load> (*loads)(const FrameTiming& timing) = nullptr;
  /// Whether its processors are the pixels of tests/rtl, whose area is known (hw/machines/area.h).
  bool bit_serial_pixels = false;
};

}  // namespace csgsim::machines
