#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/machines/machine.h"
#include "tests/rtl/vector.h"

/// The machine in Verilog, compiled by Verilator with the parameters of one build.
namespace csgsim::rtl {

/// The frame-buffer machine of the build's parameters; those of the host are defaults.
machines::Machine machine_of_parameters();

/// Number of `video` wires per pixel.
std::uint32_t colour_wires();

/// Values on the wires to the machine at an edge.
struct Inputs {
  bool reset = false;
  bool frame = false;  ///< whether the host has a frame
  bool word_valid = false;
  isa::LinkWord word{};
  std::uint8_t fault = 0;  ///< number of the planted fault (hw/rtl/faults.vh); 0: none
};

/// The counters of hw/rtl/counters.v, with their names in the machine's stats.
inline constexpr auto counted =
    std::to_array<std::string_view>({"issuing", "clearing", "starved", "answering", "jumping", "refreshing", "holding",
                                     "copying", "draining", "refresh_waits"});

/// Values on the wires from the machine after an edge. Pixel (x, y) has bit y * width + x.
struct Outputs {
  bool request = false;
  std::uint32_t request_from = 0;
  bool word_ready = false;
  bool told = false;  ///< an answer arrives
  bool told_any = false;
  bool done = false;         ///< the frame ends in this clock
  std::uint32_t clocks = 0;  ///< clocks of the frame
  bool video_valid = false;  ///< pixels are shown
  bool video_row = false;    ///< first pixels of a row
  bool video_frame = false;  ///< first pixels of a picture
  Vector video;
  bool shown = false;  ///< a picture has been shown to its end
  std::array<std::uint32_t, counted.size()> counts{};
  bool tree_valid = false;  ///< bits of F have reached the pixels
  Vector tree;
  Vector enable;
  Vector carry;
  Vector flag;
  Vector latch;   ///< the ALU's first place of every pixel, then the next
  Vector memory;  ///< bit 0 of every pixel, then bit 1
};

class Machine {
 public:
  /// The machine after reset: everything is 0.
  Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  Machine(Machine&&) = delete;
  Machine& operator=(Machine&&) = delete;
  ~Machine();

  void edge(const Inputs& inputs);
  /// An edge that afterwards provides only the outputs used by the host and its link.
  void edge_for_host(const Inputs& inputs);
  [[nodiscard]] const Outputs& outputs() const { return outputs_; }

 private:
  struct Verilated;
  void clock(const Inputs& inputs);
  void read_host();
  void read_pixels();

  std::unique_ptr<Verilated> verilated_;
  Outputs outputs_;
};

}  // namespace csgsim::rtl
