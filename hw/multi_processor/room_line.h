#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

namespace csgsim::multi_processor {

/// A common line that any node can pull.
class RoomPort : virtual public sc_core::sc_interface {
 public:
  virtual void pull(std::uint32_t node, bool pulls) = 0;
  [[nodiscard]] virtual bool is_pulled() const = 0;
};

/// The line is pulled by nodes that have no room for another command. It changes within the clock, so the line must be
/// read after all other events of the clock.
class RoomLine final : public sc_core::sc_module, public RoomPort {
 public:
  RoomLine(sc_core::sc_module_name name, std::uint32_t nodes);

  void pull(std::uint32_t node, bool pulls) override { pulls_[node] = pulls; }
  [[nodiscard]] bool is_pulled() const override;

 private:
  std::vector<bool> pulls_;
};

}  // namespace csgsim::multi_processor
