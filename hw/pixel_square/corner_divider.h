#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/division/divide.h"
#include "hw/division/model_memory.h"
#include "hw/isa/wire.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/model_receiver.h"
#include "hw/pixel_square/stepped_datapath.h"
#include "hw/pixel_square/store.h"

namespace csgsim::pixel_square {

/// What a divider is at, for waves.
struct DividerStatus {
  std::string_view state;  ///< `receiving`, `testing`, `writing`, `done`, or what it waits for
  std::optional<std::size_t> square;
};

/// A divider in the machine (thesis fig. 7.3, docs/machines/pixel-square.md). When the model has come it divides square
/// after square out of its memory: it reads, tests and writes, one thing after another, and puts a word of the square's
/// commands into the store at an edge at which there is room.
class CornerDivider final : public sc_core::sc_module {
 public:
  CornerDivider(sc_core::sc_module_name name, const machines::Machine& machine, const ModelReceiver& receiver);

  /// A frame begins, with a picture of that size. It divides those of the squares, which have to live until the frame
  /// is drawn, that it is told to, in this order.
  void begin(const machines::Size& picture, std::span<const isa::Region> squares, std::vector<std::size_t> own);

  /// Whether squares are divided by the same divider because they are in one group.
  [[nodiscard]] bool are_together(const isa::Region& one, const isa::Region& other) const;

  [[nodiscard]] Store& store() { return store_; }
  [[nodiscard]] const Store& store() const { return store_; }
  /// Of a frame of so many clocks.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const;
  [[nodiscard]] DividerStatus status() const;

 private:
  void work();
  void take_model();
  void divide(std::size_t square, SteppedDatapath& path);
  void begin_group(const isa::Region& group, SteppedDatapath& path);
  [[nodiscard]] isa::Region group_of(const isa::Region& square) const;
  [[nodiscard]] SteppedDatapath::Ends ends();
  void spend(std::uint64_t clocks);
  void let_pass();
  void store_at_once(std::span<const StoredWord> words);
  void store(const isa::Command& command, bool is_last);
  void store(const StoredWord& word);

  const machines::Machine machine_;
  const Figures& figures_;
  const sc_core::sc_time period_;
  const ModelReceiver& receiver_;
  Store store_;
  std::span<const isa::Region> squares_;
  std::vector<std::size_t> own_;
  machines::Size picture_;

  division::ModelHeader header_;
  division::ModelMemory memory_;
  std::optional<division::Divider> divider_;  ///< once the model is in
  bool far_planes_ = false;
  isa::Region group_;                         ///< that the list is of
  std::optional<division::Candidates> list_;  ///< what the group leaves, if it fits
  std::optional<std::size_t> square_;         ///< at hand
  bool begun_square_ = false;                 ///< some of it is in the store
  SquareClocks clocks_;                       ///< once the model is in
  std::uint64_t spent_ = 0;                   ///< of these, clocks that have still to go by
  std::string_view state_;
  bool is_begun_ = false;  ///< a frame, which the thread has not seen
  sc_core::sc_event begun_{"begun"};
};

}  // namespace csgsim::pixel_square
