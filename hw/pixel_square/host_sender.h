#pragma once

#include <span>

#include "hw/isa/program.h"
#include "hw/pixel_square/sender.h"

namespace csgsim::pixel_square {

/// A host that has divided the model and sends the commands of each square over its link.
class HostSender final : public Sender {
 public:
  HostSender(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Starts at the next edge. The segments must outlive the frame.
  void begin(std::span<const isa::Segment> segments);

 private:
  std::optional<SquareActivity> prepare(std::size_t square) override;
  [[nodiscard]] std::string_view preparing() const override { return name_of(SquareActivity::waiting_for_host); }
  SquareStart start(std::size_t square) override;
  [[nodiscard]] const isa::LinkWord* next_word() const override { return &words_[next_]; }
  bool advance() override { return ++next_ == words_.size(); }

  const std::uint32_t link_width_;
  const std::uint32_t latency_;
  std::span<const isa::Segment> segments_;
  std::uint32_t latency_left_ = 0;
  std::vector<isa::LinkWord> words_;  ///< words of the square in progress
  std::size_t next_ = 0;
};

}  // namespace csgsim::pixel_square
