#include "hw/pixel_planes/wave.h"

#include <sysc/tracing/sc_tracing_ids.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace csgsim::pixel_planes {

namespace {

/// Delta cycles after an edge within which every wire has its new value.
constexpr unsigned deltas_to_settle = 7;

std::string name_of(const WaveProbe& probe) {
  return "pixel_" + std::to_string(probe.x) + "_" + std::to_string(probe.y);
}

}  // namespace

void check(const WaveRequest& request, const array::PixelArray& pixels) {
  for (const WaveProbe& probe : request.probes) {
    if (probe.x >= pixels.shape().width || probe.y >= pixels.shape().height) {
      throw std::invalid_argument("wave: probe " + std::to_string(probe.x) + "," + std::to_string(probe.y) +
                                  " is outside the array");
    }
  }
  for (const isa::NamedField& named : request.fields) {
    if (named.field.end() > pixels.memory_bits()) {
      throw std::invalid_argument("wave: field " + named.name + " is outside the pixel memory");
    }
  }
}

void TextBus::set(std::string_view text) {
  bits_ = 0;
  const std::string_view shown = text.substr(0, characters);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const int low = 8 * static_cast<int>(shown.size() - 1 - i);
    bits_.range(low + 7, low) = static_cast<unsigned char>(shown[i]);
  }
}

WaveRecorder::Pixel::Pixel(unsigned alu_bits)
    : latch(static_cast<int>(alu_bits)),
      read_x(static_cast<int>(alu_bits)),
      read_y(static_cast<int>(alu_bits)),
      written(static_cast<int>(alu_bits)) {}

WaveRecorder::WaveRecorder(sc_core::sc_module_name name, const WaveTaps& taps, unsigned alu_bits)
    : sc_core::sc_module(name), taps_(taps), alu_bits_(alu_bits) {
  SC_HAS_PROCESS(WaveRecorder);
  SC_METHOD(proceed);
  dont_initialize();
  sensitive << start_;
}

void WaveRecorder::arm(WaveRequest request, std::span<const isa::Segment> segments) {
  request_ = std::move(request);
  segments_ = segments;
  segment_begin_ = 0;
  if (request_.begin >= request_.end) return;
  clock_ = request_.begin;
  next_edge_ = sc_core::sc_time_stamp() + static_cast<double>(clock_ + 1) * taps_.clock.period();
  phase_ = Phase::armed;
  start_.notify(sc_core::SC_ZERO_TIME);
}

bool WaveRecorder::finish() {
  stop();
  return std::exchange(reached_, false);
}

/// Runs at the edges of the window, and after each until the wires have settled.
void WaveRecorder::proceed() {
  switch (phase_) {
    case Phase::idle: return;
    case Phase::armed:
      if (sc_core::sc_time_stamp() < next_edge_) return next_trigger(next_edge_ - sc_core::sc_time_stamp());
      if (clock_ == request_.end) {
        stop();
        return;
      }
      phase_ = Phase::settling;
      deltas_ = 0;
      return next_trigger(sc_core::SC_ZERO_TIME);
    case Phase::settling:
      if (++deltas_ < deltas_to_settle) return next_trigger(sc_core::SC_ZERO_TIME);
      sample();
      if (file_ == nullptr) open();
      ++clock_;
      next_edge_ += taps_.clock.period();
      phase_ = Phase::armed;
      return next_trigger(taps_.clock.period());
  }
}

void WaveRecorder::open() {
  const std::filesystem::path stem = request_.file.parent_path() / request_.file.stem();
  sc_core::sc_report_handler::set_actions(sc_core::SC_ID_TRACING_TIMESCALE_DEFAULT_, sc_core::SC_DO_NOTHING);
  file_ = sc_core::sc_create_vcd_trace_file(stem.c_str());  // which appends .vcd
  reached_ = true;
  trace_controller();
  for (std::size_t i = 0; i < pixels_.size(); ++i) trace_pixel(request_.probes[i], pixels_[i]);
}

void WaveRecorder::stop() {
  phase_ = Phase::idle;
  if (file_ != nullptr) sc_core::sc_close_vcd_trace_file(file_);
  file_ = nullptr;
  pixels_.clear();
}

void WaveRecorder::trace_controller() {
  using sc_core::sc_trace;
  sc_trace(file_, taps_.clock, "clock");
  sc_trace(file_, status_.busy, "controller.busy");
  sc_trace(file_, status_.ordinal, "controller.instruction");
  sc_trace(file_, opcode_text_.bits(), "controller.opcode_text");
  sc_trace(file_, opcode_, "controller.opcode");
  sc_trace(file_, purpose_text_.bits(), "controller.purpose_text");
  sc_trace(file_, purpose_, "controller.purpose");
  sc_trace(file_, status_.instruction.origin.primitive, "controller.primitive");
  sc_trace(file_, status_.instruction.origin.node, "controller.node");
  sc_trace(file_, status_.bit, "controller.bit");
  sc_trace(file_, status_.pass, "controller.pass");
  sc_trace(file_, status_.clocks, "controller.clocks");
  sc_trace(file_, taps_.root, "root");
  sc_trace(file_, arriving_, "pixels");
  sc_trace(file_, function_text_.bits(), "pixels.function_text");
  sc_trace(file_, taps_.answer, "answer");
  sc_trace(file_, refreshes_asked_, "scan_out.refreshes_asked");
  sc_trace(file_, picture_finished_, "scan_out.picture_finished");
  sc_trace(file_, picture_latched_, "scan_out.picture_latched");
  sc_trace(file_, taps_.video, "scan_out.video");
}

void WaveRecorder::trace_pixel(const WaveProbe& probe, const Pixel& pixel) {
  using sc_core::sc_trace;
  const std::string prefix = name_of(probe) + ".";
  sc_trace(file_, pixel.registers.tree, prefix + "tree_bit");
  sc_trace(file_, pixel.registers.carry, prefix + "carry");
  sc_trace(file_, pixel.registers.enable, prefix + "enable");
  sc_trace(file_, pixel.latch, prefix + "latch");
  sc_trace(file_, pixel.read_x, prefix + "mem_read_x");
  sc_trace(file_, pixel.read_y, prefix + "mem_read_y");
  sc_trace(file_, pixel.written, prefix + "mem_written");
  for (std::size_t i = 0; i < pixel.fields.size(); ++i) {
    sc_trace(file_, pixel.fields[i], prefix + kernel::wave_identifier(request_.fields[i].name));
  }
}

/// The controller does not know whom its instruction serves; the Program does.
void WaveRecorder::find_origin() {
  while (status_.ordinal - segment_begin_ >= segments_.front().instructions.size()) {
    segment_begin_ += segments_.front().instructions.size();
    segments_ = segments_.subspan(1);
  }
  status_.instruction.origin = segments_.front().instructions[status_.ordinal - segment_begin_].origin;
}

void WaveRecorder::sample() {
  status_ = taps_.controller.status();
  if (status_.busy) find_origin();
  opcode_ = static_cast<unsigned char>(status_.instruction.opcode);
  purpose_ = static_cast<unsigned char>(status_.instruction.origin.purpose);
  opcode_text_.set(status_.busy ? isa::name_of(status_.instruction.opcode) : "");
  purpose_text_.set(status_.busy ? isa::info(status_.instruction.origin.purpose).name : "");
  executed_ = std::exchange(arriving_, taps_.control_at_pixels.read());
  function_text_.set(array::info(arriving_.step.function).name);
  refreshes_asked_ = static_cast<unsigned char>(taps_.refreshes.num_available());
  picture_finished_ = taps_.pictures.num_available() > 0;
  picture_latched_ = taps_.latched.num_available() > 0;
  if (pixels_.size() != request_.probes.size()) {
    for (std::size_t i = 0; i < request_.probes.size(); ++i) {
      Pixel& pixel = pixels_.emplace_back(alu_bits_);
      for (const isa::NamedField& named : request_.fields) pixel.fields.emplace_back(named.field.width);
    }
  }
  for (std::size_t i = 0; i < pixels_.size(); ++i) sample_pixel(request_.probes[i], arriving_, pixels_[i]);
}

void WaveRecorder::sample_pixel(const WaveProbe& probe, const ControlWord& word, Pixel& pixel) const {
  const array::AluInfo& row = array::info(word.step.function);
  const bool x_from_memory = row.reads_x && word.step.source == array::OperandSource::memory;
  pixel.registers = taps_.processors.probe(probe.x, probe.y);
  pixel.latch = pixel.registers.latch;
  pixel.read_x = x_from_memory ? field_value(probe, {word.step.x, word.step.bits}) : 0;
  pixel.read_y = row.reads_y ? field_value(probe, {word.step.y, word.step.bits}) : 0;
  const bool writes = array::info(executed_.step.function).writes;
  pixel.written = writes ? field_value(probe, {executed_.step.write, executed_.step.bits}) : 0;
  for (std::size_t i = 0; i < pixel.fields.size(); ++i) {
    pixel.fields[i] = field_value(probe, request_.fields[i].field);
  }
}

std::uint64_t WaveRecorder::field_value(const WaveProbe& probe, isa::Field field) const {
  std::uint64_t value = 0;
  for (unsigned bit = 0; bit < field.width; ++bit) {
    const bool is_set = taps_.processors.pixels().memory_bit(field.base + bit, probe.x, probe.y);
    value |= static_cast<std::uint64_t>(is_set) << bit;
  }
  return value;
}

}  // namespace csgsim::pixel_planes
