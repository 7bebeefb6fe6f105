#pragma once

#include <cstddef>
#include <vector>

#include "hw/pixel_square/sender.h"
#include "hw/pixel_square/store.h"

namespace csgsim::pixel_square {

/// Sends what dividers have stored, square after square, a word a clock. A square is begun when all of it is there, or
/// no more of it fits: then the rest follows as there is room.
class StoreSender final : public Sender {
 public:
  StoreSender(sc_core::sc_module_name name, const machines::Machine& machine) : Sender(name, machine, 1) {}

  /// Starts at the next edge: the squares, and of each the store that it comes from. Both have to live until the frame
  /// is drawn.
  void begin(std::span<const isa::Region> squares, std::vector<Store*> stores);

 private:
  std::optional<SquareActivity> prepare(std::size_t square) override;
  [[nodiscard]] const sc_core::sc_event* prepared(std::size_t square) const override {
    return &stores_[square]->ready();
  }
  [[nodiscard]] std::string_view preparing() const override { return name_of(SquareActivity::waiting_for_divider); }
  SquareStart start(std::size_t square) override;
  [[nodiscard]] const isa::LinkWord* next_word() const override;
  bool pass() override;

  std::span<const isa::Region> squares_;
  std::vector<Store*> stores_;
  Store* store_ = nullptr;  ///< of the square at hand
};

}  // namespace csgsim::pixel_square
