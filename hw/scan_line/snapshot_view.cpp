#include "hw/scan_line/snapshot_view.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace csgsim::scan_line {

namespace {

void require(bool kept) {
  if (!kept) throw std::logic_error("a run listener reads cells that it did not request");
}

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
  return std::make_unique<SnapshotView>(
      std::make_shared<const Snapshot>(snapshot_ == nullptr ? Snapshot{} : *snapshot_));
}

}  // namespace csgsim::scan_line
