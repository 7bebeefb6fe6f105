#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/controller.h"
#include "hw/pixel_planes/pixel_processors.h"
#include "hw/systemc/wave_request.h"

namespace csgsim::pixel_planes {

using kernel::WaveProbe;
using kernel::WaveRequest;

/// Throws std::invalid_argument for a probe or field outside the array.
void check(const WaveRequest& request, const array::PixelArray& pixels);

/// Where the recorder looks.
struct WaveTaps {
  const sc_core::sc_clock& clock;
  const Controller& controller;
  const PixelProcessors& processors;
  const sc_core::sc_signal<RootWord>& root;
  const sc_core::sc_signal<ControlWord>& control_at_pixels;
  const sc_core::sc_signal<Answer>& answer;
  const sc_core::sc_fifo<RefreshStep>& refreshes;
  const sc_core::sc_fifo<FinishedPicture>& pictures;
  const sc_core::sc_fifo<bool>& latched;
  const sc_core::sc_signal<std::uint32_t>& video;
};

/// A text as a bus, eight bits a character, the first character highest; wave viewers show it as ASCII.
class TextBus {
 public:
  static constexpr int characters = 20;

  void set(std::string_view text);
  [[nodiscard]] const sc_dt::sc_bv_base& bits() const { return bits_; }

 private:
  sc_dt::sc_bv<8 * characters> bits_;
};

/// Records a window of a run as a VCD file: clock, controller, tree roots, control word and registers and fields of the
/// probed pixels. The file exists from the window's first clock on. Outside a window the recorder does nothing.
class WaveRecorder final : public sc_core::sc_module {
 public:
  /// `alu_bits`: width of the buses from and to pixel memory.
  WaveRecorder(sc_core::sc_module_name name, const WaveTaps& taps, unsigned alu_bits);

  /// Records the run that starts now. The segments, which say whom an instruction serves, have to live until finish.
  void arm(WaveRequest request, std::span<const isa::Segment> segments);

  /// Closes the file if the run has ended inside the window. Says whether the window was reached.
  bool finish();

 private:
  enum class Phase : std::uint8_t { idle, armed, settling };

  /// One probed pixel in the current clock.
  struct Pixel {
    explicit Pixel(unsigned alu_bits);

    array::PixelProbe registers;
    sc_dt::sc_uint_base latch;
    sc_dt::sc_uint_base read_x;   ///< memory bits on the first read port
    sc_dt::sc_uint_base read_y;   ///< on the second, or on the only one if operand x is not from memory
    sc_dt::sc_uint_base written;  ///< memory bits that the step before has written
    std::vector<sc_dt::sc_uint_base> fields;
  };

  void proceed();
  void find_origin();
  void open();
  void stop();
  void trace_controller();
  void trace_pixel(const WaveProbe& probe, const Pixel& pixel);
  void sample();
  void sample_pixel(const WaveProbe& probe, const ControlWord& word, Pixel& pixel) const;
  [[nodiscard]] std::uint64_t field_value(const WaveProbe& probe, isa::Field field) const;

  WaveTaps taps_;
  unsigned alu_bits_;
  WaveRequest request_;
  std::span<const isa::Segment> segments_;  ///< from the one on that the controller is at
  std::uint64_t segment_begin_ = 0;         ///< ordinal of its first instruction
  Phase phase_ = Phase::idle;
  sc_core::sc_time next_edge_;
  std::uint64_t clock_ = 0;  ///< of the program, at next_edge_
  unsigned deltas_ = 0;
  sc_core::sc_trace_file* file_ = nullptr;
  bool reached_ = false;

  ControllerStatus status_;
  unsigned char opcode_ = 0;
  unsigned char purpose_ = 0;
  TextBus opcode_text_;
  TextBus purpose_text_;
  TextBus function_text_;
  ControlWord executed_;               ///< the word that the pixels carried out last
  ControlWord arriving_;               ///< the word that they carry out at the next edge
  unsigned char refreshes_asked_ = 0;  ///< refresh words that the scan-out waits for
  bool picture_finished_ = false;      ///< the controller tells the scan-out of a picture
  bool picture_latched_ = false;       ///< the scan-out tells the controller that it has latched the last row
  std::deque<Pixel> pixels_;
  sc_core::sc_event start_{"start"};
};

}  // namespace csgsim::pixel_planes
