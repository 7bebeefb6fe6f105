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

/// State of a divider, for waves.
struct DividerStatus {
  std::string_view state;  ///< `receiving`, `testing`, `writing`, `done`, or the name of the reason for waiting
  std::optional<std::size_t> square;  ///< index of the square that is being divided
};

/// A divider in the machine (thesis fig. 7.3, docs/machines/pixel-square.md). After the model has been received, it
/// divides one square after another from its memory: it reads, tests and writes sequentially, and writes each word of
/// the square's commands to the store as soon as the store has room.
class CornerDivider final : public sc_core::sc_module {
 public:
  CornerDivider(sc_core::sc_module_name name, const machines::Machine& machine, const ModelReceiver& receiver);

  /// Begins a frame with a picture of the given size. The divider divides the squares with the indices `assigned`, in
  /// this order. `squares` must outlive the frame.
  void begin(const machines::Size& picture, std::span<const isa::Region> squares, std::vector<std::size_t> assigned);

  /// Whether both squares lie in one group, so that the same divider divides them.
  [[nodiscard]] bool are_in_same_group(const isa::Region& first, const isa::Region& second) const;

  [[nodiscard]] Store& store() { return store_; }
  [[nodiscard]] const Store& store() const { return store_; }
  /// Clocks by activity in a frame of `clocks` clocks.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const;
  [[nodiscard]] DividerStatus status() const;

 private:
  void work();
  void receive_model();
  void divide(std::size_t square, SteppedDatapath& path);
  void begin_group(const isa::Region& group, SteppedDatapath& path);
  [[nodiscard]] isa::Region enclosing_group(const isa::Region& square) const;
  [[nodiscard]] SteppedDatapath::Callbacks callbacks();
  void spend(std::uint64_t clocks);
  void wait_spent();
  void store_at_once(std::span<const StoredWord> words);
  void store(const isa::Command& command, bool is_last);
  void store(const StoredWord& word);

  const machines::Machine machine_;
  const Figures& figures_;
  const sc_core::sc_time period_;
  const ModelReceiver& receiver_;
  Store store_;
  std::span<const isa::Region> squares_;
  std::vector<std::size_t> assigned_;
  machines::Size picture_;

  division::ModelHeader header_;
  division::ModelMemory memory_;
  std::optional<division::Divider> divider_;  ///< set once the model has been received
  bool remote_planes_ = false;
  isa::Region group_;                         ///< group that the list belongs to
  std::optional<division::Candidates> list_;  ///< result of the first level for the group, if it fits the list memory
  std::optional<std::size_t> square_;         ///< square in progress
  bool begun_square_ = false;                 ///< whether part of the square is in the store
  SquareClocks clocks_;                       ///< counted since the model was received
  std::uint64_t spent_ = 0;                   ///< counted clocks for which the divider has not waited yet
  std::string_view state_;
  bool frame_pending_ = false;  ///< whether a frame has begun that the thread has not processed yet
  sc_core::sc_event begun_{"begun"};
};

}  // namespace csgsim::pixel_square
