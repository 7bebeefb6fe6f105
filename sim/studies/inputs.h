#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace csgsim::studies {

/// What a row was measured from, beside what its point and the title of its table say.
struct Inputs {
  std::string model_hash;    ///< of the bytes of the model's file
  std::string machine_hash;  ///< of every figure of the machine as it was read
  std::string csgsim;        ///< the program's version and build

  bool operator==(const Inputs&) const = default;

  static void columns(auto& inputs, const auto& visit) {
    visit("model_hash", inputs.model_hash);
    visit("machine_hash", inputs.machine_hash);
    visit("csgsim", inputs.csgsim);
  }
};

inline constexpr std::size_t input_columns = 3;

/// What differs, for people: `the model`, `the machine`, `csgsim`.
std::vector<std::string> differences(const Inputs& before, const Inputs& now);

}  // namespace csgsim::studies
