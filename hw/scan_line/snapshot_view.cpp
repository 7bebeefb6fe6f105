#include "hw/scan_line/snapshot_view.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace csgsim::scan_line {

namespace {

void require(bool kept) {
  if (!kept) throw std::logic_error("who watches a run reads cells without having asked for them");
}

/// A view that has its snapshot to itself.
class OwnedSnapshot final : public systemc::PixelView {
 public:
  explicit OwnedSnapshot(Snapshot snapshot) : snapshot_(std::move(snapshot)) {}

  void read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                  std::span<std::uint32_t> values) const override {
    SnapshotView(&snapshot_).read_field(field, width, height, values);
  }
  void read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const override {
    SnapshotView(&snapshot_).read_enable(width, height, words);
  }
  [[nodiscard]] std::unique_ptr<const systemc::PixelView> copy() const override {
    return SnapshotView(&snapshot_).copy();
  }

 private:
  Snapshot snapshot_;
};

}  // namespace

void SnapshotView::read_field(isa::Field field, std::uint32_t width, std::uint32_t /*height*/,
                              std::span<std::uint32_t> values) const {
  require(snapshot_ != nullptr && !snapshot_->memory.empty());
  for (std::uint32_t x = 0; x < width; ++x) values[x] = static_cast<std::uint32_t>(snapshot_->read(x, field));
}

void SnapshotView::read_enable(std::uint32_t /*width*/, std::uint32_t /*height*/,
                               std::span<std::uint64_t> words) const {
  require(snapshot_ != nullptr && !snapshot_->enable.empty());
  std::copy_n(snapshot_->enable.begin(), words.size(), words.begin());
}

std::unique_ptr<const systemc::PixelView> SnapshotView::copy() const {
  return std::make_unique<OwnedSnapshot>(snapshot_ == nullptr ? Snapshot{} : *snapshot_);
}

}  // namespace csgsim::scan_line
