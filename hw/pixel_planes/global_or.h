// The global OR of the enable bits. Used by hw/pixel_planes and hw/pixel_square.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <systemc>
#include <vector>

#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/pixel_ports.h"

namespace csgsim::pixel_planes {

/// The OR of all enable bits: a tree of gates, each followed by a register. The result of a test arrives at the
/// controller one clock per level after the control word of the global-OR test has reached the pixels. Without levels
/// the OR is a wire, and the result arrives in the same clock.
class GlobalOr final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<bool> question{"question"};
  sc_core::sc_port<EnableLines> enable{"enable"};
  sc_core::sc_out<Answer> answer{"answer"};

  /// `fan_in`: inputs per gate; 0 for a single gate that settles within the clock.
  GlobalOr(sc_core::sc_module_name name, array::PlaneShape shape, std::uint32_t fan_in);

  /// Queues the results of the next global-OR tests, in order, for a machine of which only some pixels are simulated.
  void set_test_results(std::vector<bool> results);

 private:
  /// Registers after the gates of one level of the tree.
  struct Level {
    bool pending = false;  ///< whether the registers hold data of a test
    std::vector<bool> bits;
  };

  [[nodiscard]] bool any_enabled();
  void reduce();
  void shift();
  void reduce_enable(Level& level);
  void reduce_level(const Level& from, Level& to) const;

  array::PlaneShape shape_;
  std::uint32_t fan_in_;
  std::vector<Level> levels_;  ///< from the pixels to the controller
  std::optional<std::deque<bool>> known_results_;
};

}  // namespace csgsim::pixel_planes
