#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/division/divide.h"
#include "hw/pixel_square/sender.h"

namespace csgsim::pixel_square {

/// A divider in the machine (thesis fig. 7.3, docs/division.md). It takes the model from the link into its memory, a
/// word a clock, and then divides square after square. First it tests: for the first square of a group all that the
/// group asks for, then what the square asks for, in as many clocks as these tests take. When they are done the
/// square's commands leave, a word a clock; the next square's tests begin when the last has left.
class CornerDivider final : public Sender {
 public:
  sc_core::sc_fifo_in<isa::LinkWord> model{"model"};

  CornerDivider(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Starts at the next edge, with a picture of that size and a model of so many bytes, one at least.
  void begin(const machines::Size& picture, std::uint64_t model_bytes);

 private:
  std::optional<SquareActivity> prepare(std::size_t square) override;
  [[nodiscard]] std::string_view preparing() const override { return divider_ ? "testing" : "receiving"; }
  Square take(std::size_t square) override;
  SquareActivity take_model();
  void begin_tests(std::size_t square);
  void begin_group(const isa::Region& group);
  [[nodiscard]] isa::Region group_of(const isa::Region& square) const;
  [[nodiscard]] std::uint64_t clocks_of(const division::Counts& counts) const;

  const machines::Machine machine_;
  std::vector<isa::Region> squares_;
  machines::Size picture_;
  std::vector<isa::LinkWord> memory_;  ///< the bytes of the model that have come, one an element
  std::uint64_t model_bytes_ = 0;
  std::uint64_t bits_taken_ = 0;
  std::optional<division::Divider> divider_;  ///< once the model is in
  isa::Region group_;                         ///< that the list is of
  std::optional<division::Candidates> list_;  ///< what the group leaves, if it fits
  std::optional<std::size_t> tested_;         ///< the square at hand
  division::Divided divided_;
  std::uint64_t tests_left_ = 0;  ///< clocks
};

}  // namespace csgsim::pixel_square
