#pragma once

#include <cstdint>
#include <systemc>

#include "hw/pixel_square/activity_counter.h"
#include "hw/pixel_square/words.h"

namespace csgsim::pixel_square {

/// Sends the model, a word a primitive and a word a half-space. A word takes `word_clocks` clocks and leaves in the
/// last of them, or in the first after it in which the FIFO has room.
class Host final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_out<ModelWord> model{"model"};

  Host(sc_core::sc_module_name name, std::uint32_t word_clocks);

  /// Sends that many words from the next edge on.
  void begin(std::uint64_t words);

  [[nodiscard]] const machines::SquareClocks& account() const { return counter_.clocks(); }

 private:
  void on_clock();
  machines::SquareActivity act();

  const std::uint32_t word_clocks_;
  std::uint64_t words_left_ = 0;
  std::uint32_t elapsed_ = 0;  ///< clocks spent on the word at hand
  ActivityCounter counter_;
};

}  // namespace csgsim::pixel_square
