#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

namespace csgsim::multi_processor {

/// A common line that any node can pull.
class RoomPort : virtual public sc_core::sc_interface {
 public:
  /// Sets whether the node pulls the line.
  virtual void set_pulled(std::uint32_t node, bool is_pulled_by_node) = 0;
  [[nodiscard]] virtual bool is_pulled() const = 0;
};

/// The line that nodes pull when they have no room for another command. Its level changes within the clock, so the line
/// must be read after all other events of the clock.
class RoomLine final : public sc_core::sc_module, public RoomPort {
 public:
  RoomLine(sc_core::sc_module_name name, std::uint32_t nodes);

  void set_pulled(std::uint32_t node, bool is_pulled_by_node) override { pulls_[node] = is_pulled_by_node; }
  [[nodiscard]] bool is_pulled() const override;

 private:
  std::vector<bool> pulls_;
};

}  // namespace csgsim::multi_processor
