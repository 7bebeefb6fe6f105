#pragma once

#include <cstddef>
#include <vector>

#include "hw/pixel_square/sender.h"
#include "hw/pixel_square/store.h"

namespace csgsim::pixel_square {

/// Sends the squares that dividers have stored, one after another, one word per clock. Sending of a square begins when
/// it is complete, or when the store is full; then its remaining words follow as they are stored.
class StoreSender final : public Sender {
 public:
  StoreSender(sc_core::sc_module_name name, const machines::Machine& machine) : Sender(name, machine, 1) {}

  /// Starts at the next edge. `stores` gives the store of each square. Squares and stores must outlive the frame.
  void begin(std::span<const isa::Region> squares, std::vector<Store*> stores);

 private:
  std::optional<SquareActivity> prepare(std::size_t square) override;
  [[nodiscard]] const sc_core::sc_event* prepared(std::size_t square) const override {
    return &stores_[square]->ready();
  }
  [[nodiscard]] std::string_view preparing() const override { return name_of(SquareActivity::waiting_for_divider); }
  SquareStart start(std::size_t square) override;
  [[nodiscard]] const isa::LinkWord* next_word() const override;
  bool advance() override;

  std::span<const isa::Region> squares_;
  std::vector<Store*> stores_;
  Store* store_ = nullptr;  ///< store of the square in progress
};

}  // namespace csgsim::pixel_square
