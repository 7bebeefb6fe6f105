#pragma once

#include <memory>
#include <utility>

#include "hw/scan_line/snapshot.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::scan_line {

/// View of the cells of a line as a packet left them: each cell in its state at the end of the packet's instruction.
/// Throws std::logic_error for data that the snapshot does not contain.
class SnapshotView final : public systemc::PixelView {
 public:
  /// `snapshot` is null if no state was kept; it must outlive the view.
  explicit SnapshotView(const Snapshot* snapshot) : snapshot_(std::shared_ptr<void>(), snapshot) {}
  explicit SnapshotView(std::shared_ptr<const Snapshot> snapshot) : snapshot_(std::move(snapshot)) {}

  void read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                  std::span<std::uint32_t> values) const override;
  void read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const override;
  [[nodiscard]] std::unique_ptr<const systemc::PixelView> copy() const override;

 private:
  std::shared_ptr<const Snapshot> snapshot_;
};

}  // namespace csgsim::scan_line
