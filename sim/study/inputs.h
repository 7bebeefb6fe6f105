#pragma once

#include <concepts>
#include <string>
#include <type_traits>
#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::study {

/// What a row was measured from, beside what its point and the title of its table say.
struct Inputs {
  std::string model_hash;    ///< of the bytes of the model's file
  std::string machine_hash;  ///< of every figure of the machine as it was read
  std::string csgsim;        ///< the program's version and build

  bool operator==(const Inputs&) const = default;
};

template <class Members, class Visitor>
requires std::same_as<std::remove_const_t<Members>, Inputs>
void visit_columns(Members& inputs, Visitor&& visit) {
  visit("model_hash", inputs.model_hash);
  visit("machine_hash", inputs.machine_hash);
  visit("csgsim", inputs.csgsim);
}

/// Of all figures of a machine's description, in whatever order and with whatever comments it is written.
std::string hash_of(const machines::Machine& machine);

/// What differs, for people: `the model`, `the machine`, `csgsim`.
std::vector<std::string> differences(const Inputs& before, const Inputs& now);

}  // namespace csgsim::study
