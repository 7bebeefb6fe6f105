// The inputs that a row was measured from.
// Used to detect stale rows of tables and shards.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace csgsim::studies {

/// The inputs of a row that neither its point nor the title of its table specifies.
struct Inputs {
  std::string model_hash;    ///< hash of the bytes of the model's file
  std::string machine_hash;  ///< hash of all parameters of the machine
  std::string csgsim;        ///< version and build of the program

  bool operator==(const Inputs&) const = default;

  static void columns(auto& inputs, const auto& visit) {
    visit("model_hash", inputs.model_hash);
    visit("machine_hash", inputs.machine_hash);
    visit("csgsim", inputs.csgsim);
  }
};

inline constexpr std::size_t input_columns = 3;

/// The inputs that differ, as text: `the model`, `the machine`, `csgsim`.
std::vector<std::string> changed_inputs(const Inputs& before, const Inputs& now);

}  // namespace csgsim::studies
