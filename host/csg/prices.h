// Times of the host's pruning tests, which decide whether a test is worth its time.
// Used by host/emit and sim/session.
#pragma once

namespace csgsim::csg {

/// Time of the host and of the machine in nanoseconds. The default is a host that takes no time.
struct Prices {
  bool are_weighed = false;  ///< whether tests that are not worth their time are left out (`--pruning auto`)
  double box = 0;            ///< two boxes are compared
  double test = 0;           ///< a half-space is tested at the corners of a rectangle
  double value = 0;          ///< two planes' values are compared
  double support = 0;        ///< a point is evaluated in a direction
  double instruction = 0;    ///< an instruction with an expression: written by the host and executed by the machine

  /// Whether to make a test that takes `nanoseconds` and saves that number of instructions if it succeeds. Half of the
  /// tests are assumed to succeed.
  [[nodiscard]] bool is_worthwhile(double instructions, double nanoseconds) const {
    return !are_weighed || 2 * nanoseconds <= instructions * instruction;
  }

  bool operator==(const Prices&) const = default;
};

}  // namespace csgsim::csg
