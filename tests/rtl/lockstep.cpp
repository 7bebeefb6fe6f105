#include "tests/rtl/lockstep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "hw/array/plane.h"
#include "hw/link/frame_words.h"

namespace csgsim::rtl {

namespace {

void put(Vector& vector, std::size_t bit, std::uint64_t value) { vector[bit / 64] |= value << bit % 64; }

/// A plane of the SystemC machine, whose rows begin at whole words, without gaps.
void pack(std::span<const std::uint64_t> plane, array::PlaneShape shape, Vector& to) {
  to.assign((std::size_t{shape.width} * shape.height + 63) / 64, 0);
  std::size_t bit = 0;
  for (std::uint32_t y = 0; y < shape.height; ++y) {
    for (std::uint32_t x = 0; x < shape.width; ++x) put(to, bit++, array::bit_of(plane, shape, x, y) ? 1 : 0);
  }
}

/// `count` bits of a vector from bit `first` on.
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
      host_(machine.link) {
  SC_HAS_PROCESS(Lockstep);
  SC_METHOD(watch);
}

std::uint64_t Lockstep::edges() const {
  return static_cast<std::uint64_t>(std::floor(sc_core::sc_time_stamp() / machine_.period()));
}

std::string Lockstep::run(const isa::Program& program, std::uint8_t fault) {
  fault_ = fault;
  host_.load(link::frame_words(program, figures_.link.width));
  answers_.clear();
  frames_done_ = 0;
  begin_ = edges() + 1;
  comparing_ = true;
  systemc::RunListener nobody;
  const systemc::RunReport report = machine_.run(program, nobody);
  look();
  comparing_ = false;
  std::string difference = std::move(difference_);
  difference_.clear();
  if (difference.empty() && frames_done_ != 1) difference = "the Verilog is not done with the frame";
  if (difference.empty() && clocks_ != report.clocks)
    difference = fmt::format("{} clocks in SystemC, {} in Verilog", report.clocks, clocks_);
  if (difference.empty() && answers_ != report.answers) difference = "the answers differ";
  if (!difference.empty()) clear();
  return difference;
}

/// After a difference: all is 0 on both.
void Lockstep::clear() {
  isa::Program program;
  program.shape = figures_.array;
  program.segments.resize(1);
  program.segments[0].region = {0, 0, figures_.array.width, figures_.array.height};
  systemc::RunListener nobody;
  machine_.run(program, nobody);
  rtl_ = std::make_unique<Machine>();
}

/// In the middle of a clock all is settled.
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
  Inputs inputs{.frame = seen_ == begin_, .fault = fault_};
  host_.drive(rtl_->outputs(), inputs);
  rtl_->edge(inputs);
  const Outputs& outputs = rtl_->outputs();
  if (outputs.told) answers_.push_back(outputs.told_any);
  if (outputs.done) {
    ++frames_done_;
    clocks_ = outputs.clocks;
  }
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
