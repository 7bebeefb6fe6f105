#include "tests/rtl/lockstep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "hw/array/plane.h"
#include "hw/link/frame_words.h"
#include "hw/machines/regions.h"
#include "hw/pixel_planes/figures.h"

namespace csgsim::rtl {

namespace {

void put(Vector& vector, std::size_t bit, std::uint64_t value) { vector[bit / 64] |= value << bit % 64; }

/// Packs a plane of the SystemC machine, whose rows begin at whole words, into a vector without gaps.
void pack(std::span<const std::uint64_t> plane, array::PlaneShape shape, Vector& to) {
  to.assign((std::size_t{shape.width} * shape.height + 63) / 64, 0);
  std::size_t bit = 0;
  for (std::uint32_t y = 0; y < shape.height; ++y) {
    for (std::uint32_t x = 0; x < shape.width; ++x) put(to, bit++, array::bit_of(plane, shape, x, y) ? 1 : 0);
  }
}

/// Copies `count` bits of a vector from bit `first` on.
void take(const Vector& from, std::size_t first, std::size_t count, Vector& to) {
  to.assign((count + 63) / 64, 0);
  for (std::size_t word = 0; word < to.size(); ++word) {
    const std::size_t at = first + word * 64;
    std::uint64_t value = from[at / 64] >> at % 64;
    if (at % 64 != 0 && at / 64 + 1 < from.size()) value |= from[at / 64 + 1] << (64 - at % 64);
    to[word] = value & array::low_bits(std::min<std::size_t>(64, count - word * 64));
  }
}

}  // namespace

Lockstep::Lockstep(const machines::Machine& machine)
    : sc_module(sc_core::sc_module_name("lockstep")),
      figures_(machine),
      machine_("machine", machine),
      rtl_(std::make_unique<Machine>()),
      host_(machine.link),
      screen_(machine.array.width, machines::kind_figures<pixel_planes::Figures>(machine).scan_out_pixels,
              colour_wires()) {
  SC_HAS_PROCESS(Lockstep);
  SC_METHOD(watch);
}

std::uint64_t Lockstep::edges() const {
  return static_cast<std::uint64_t>(std::floor(sc_core::sc_time_stamp() / machine_.period()));
}

std::string Lockstep::run(std::span<const isa::Program> programs, std::uint8_t fault) {
  fault_ = fault;
  programs_ = programs;
  frames_.clear();
  drawn_ = 0;
  scanned_out_ = 0;
  begin_ = edges() + 1;
  next_frame();
  comparing_ = true;
  systemc::RunListener nobody;
  const std::vector<systemc::RunListener*> listeners(programs.size(), &nobody);
  const std::vector<systemc::RunReport> reports = machine_.run_sequence(programs, listeners);
  look();
  comparing_ = false;
  compare_frames(reports);
  std::string difference = std::move(difference_);
  difference_.clear();
  if (!difference.empty()) clear();
  return difference;
}

/// Loads the next frame into the host's memory.
void Lockstep::next_frame() {
  host_.load(link::frame_words(programs_[drawn_], figures_.link.width));
  waiting_ = true;
}

/// Clears both machines after a difference.
void Lockstep::clear() {
  isa::Program program;
  program.shape = figures_.array;
  program.segments.resize(1);
  program.segments[0].region = {0, 0, figures_.array.width, figures_.array.height};
  systemc::RunListener nobody;
  machine_.run(program, nobody);
  look();
  rtl_ = std::make_unique<Machine>();
}

/// Compares the machines in the middle of a clock, when all signals have settled.
void Lockstep::watch() {
  if (sc_core::sc_time_stamp() == sc_core::SC_ZERO_TIME) return next_trigger(machine_.period() * 1.5);
  look();
  next_trigger(machine_.period());
}

void Lockstep::look() {
  if (seen_ == edges()) return;
  seen_ = edges();
  if (!comparing_) return;
  edge();
  if (difference_.empty()) compare();
}

void Lockstep::edge() {
  Inputs inputs{.frame = waiting_, .fault = fault_};
  host_.drive(rtl_->outputs(), inputs);
  rtl_->edge(inputs);
  const Outputs& outputs = rtl_->outputs();
  screen_.show(outputs);
  if (waiting_ && outputs.request && outputs.request_from == 0) {
    waiting_ = false;
    frames_.push_back({.begun = seen_});
  }
  if (frames_.empty()) return;
  if (outputs.told) frames_.back().answers.push_back(outputs.told_any);
  if (outputs.done) finish_frame();
  if (!outputs.shown) return;
  while (scanned_out_ < frames_.size() && isa::frame_header(programs_[scanned_out_]).colour.width == 0) ++scanned_out_;
  if (scanned_out_ == frames_.size()) return report_difference("the Verilog shows an unexpected picture");
  frames_[scanned_out_].shown = seen_;
  frames_[scanned_out_++].picture = screen_.picture();
}

/// Records the end of the frame that the Verilog is drawing.
void Lockstep::finish_frame() {
  if (drawn_ == frames_.size()) return report_difference("the Verilog ends an unexpected frame");
  Frame& frame = frames_[drawn_];
  frame.clocks = rtl_->outputs().clocks;
  frame.counts = rtl_->outputs().counts;
  isa::Field colour = isa::frame_header(programs_[drawn_]).colour;
  if (const isa::Field copied = machines::second_buffer(colour.width, figures_); copied.width > 0) colour = copied;
  const array::PixelArray& pixels = machine_.processors().pixels();
  for (std::uint32_t i = 0; colour.width > 0 && i < figures_.array.width * figures_.array.height; ++i) {
    std::uint32_t& pixel = frame.drawn.emplace_back(0);
    for (std::uint32_t bit = 0; bit < colour.width; ++bit) {
      const bool one = array::bit_of(pixels.memory(colour.base + bit), pixels.shape(), i % figures_.array.width,
                                     i / figures_.array.width);
      pixel |= (one ? 1U : 0U) << bit;
    }
  }
  if (++drawn_ < programs_.size()) next_frame();
}

void Lockstep::report_difference(std::string difference) {
  if (difference_.empty()) difference_ = std::move(difference);
}

void Lockstep::compare_frames(const std::vector<systemc::RunReport>& reports) {
  if (drawn_ != programs_.size()) return report_difference("the Verilog has not ended all frames");
  for (std::size_t i = 0; i < frames_.size(); ++i) compare_frame(i, reports[i]);
}

void Lockstep::compare_frame(std::size_t number, const systemc::RunReport& report) {
  const Frame& frame = frames_[number];
  const auto expect = [&](std::string_view what, std::uint64_t expected, std::uint64_t actual) {
    if (expected != actual)
      report_difference(fmt::format("frame {}: {} {} in SystemC, {} in Verilog", number, what, expected, actual));
  };
  expect("clocks", report.clocks, frame.clocks);
  if (frame.answers != report.answers) report_difference(fmt::format("frame {}: the answers differ", number));
  const auto& activities = report.account.parts.front().clocks;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    const auto found = std::find_if(activities.begin(), activities.end(),
                                    [&](const auto& activity) { return activity.activity == counted.at(i); });
    if (found != activities.end()) expect(counted.at(i), found->clocks, frame.counts.at(i));
  }
  const bool tells_waits = machines::kind_figures<pixel_planes::Figures>(figures_).scan_out_buffers > 1;
  if (tells_waits) expect("refresh_waits", report.account.count("refresh_waits"), frame.counts.back());
  if (number + 1 < frames_.size())
    expect("interval_clocks", report.interval_clocks, frames_[number + 1].begun - frame.begun);
  if (isa::frame_header(programs_[number]).colour.width == 0) return;
  expect("shown_clocks", report.shown_clocks, frame.shown - frame.begun);
  if (frame.picture != frame.drawn)
    report_difference(fmt::format("frame {}: the scanned-out picture differs from the drawn one", number));
  if (!report.picture.empty() && frame.picture != report.picture)
    report_difference(fmt::format("frame {}: the pictures differ", number));
}

void Lockstep::compare_plane(const char* what, const Vector& expected, const Vector& actual, std::string_view which) {
  if (expected == actual || !difference_.empty()) return;
  for (std::size_t bit = 0; bit < expected.size() * 64; ++bit) {
    if (((expected[bit / 64] ^ actual[bit / 64]) >> bit % 64 & 1U) == 0) continue;
    difference_ =
        fmt::format("clock {}, pixel ({}, {}): {}{} is {} in SystemC", seen_ - begin_, bit % figures_.array.width,
                    bit / figures_.array.width, what, which, expected[bit / 64] >> bit % 64 & 1U);
    return;
  }
}

void Lockstep::compare() {
  ++clocks_compared_;
  const array::PixelArray& pixels = machine_.processors().pixels();
  const array::PlaneShape shape = pixels.shape();
  const std::size_t count = std::size_t{shape.width} * shape.height;
  const Outputs& outputs = rtl_->outputs();

  Vector carry((count + 63) / 64);
  Vector flag((count + 63) / 64);
  Vector tree((count + 63) / 64);
  std::vector<Vector> latch(figures_.alu_bits, Vector((count + 63) / 64));
  for (std::size_t i = 0; i < count; ++i) {
    const array::PixelProbe probe = machine_.processors().probe(static_cast<std::uint32_t>(i % shape.width),
                                                                static_cast<std::uint32_t>(i / shape.width));
    put(carry, i, probe.carry ? 1 : 0);
    put(flag, i, probe.flag ? 1 : 0);
    put(tree, i, probe.tree ? 1 : 0);
    for (std::size_t place = 0; place < latch.size(); ++place) put(latch[place], i, probe.latch >> place & 1U);
  }
  Vector actual;
  if (outputs.tree_valid) compare_plane("the bit of F", tree, outputs.tree);
  pack(pixels.enable(), shape, plane_);
  compare_plane("enable", plane_, outputs.enable);
  compare_plane("carry", carry, outputs.carry);
  compare_plane("flag", flag, outputs.flag);
  for (std::size_t place = 0; place < latch.size(); ++place) {
    take(outputs.latch, place * count, count, actual);
    compare_plane("latch, place ", latch[place], actual, std::to_string(place));
  }
  for (std::uint32_t address = 0; address < pixels.memory_bits(); ++address) {
    pack(pixels.memory(address), shape, plane_);
    take(outputs.memory, address * count, count, actual);
    if (plane_ != actual) compare_plane("memory bit ", plane_, actual, std::to_string(address));
  }
}

}  // namespace csgsim::rtl
