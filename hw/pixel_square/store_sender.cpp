#include "hw/pixel_square/store_sender.h"

#include <utility>

namespace csgsim::pixel_square {

void StoreSender::begin(std::span<const isa::Region> squares, std::vector<Store*> stores) {
  squares_ = squares;
  stores_ = std::move(stores);
  begin_frame(squares.size());
}

std::optional<SquareActivity> StoreSender::prepare(std::size_t square) {
  if (stores_[square]->may_begin()) return std::nullopt;
  return SquareActivity::waiting_for_divider;
}

SquareStart StoreSender::start(std::size_t square) {
  store_ = stores_[square];
  const bool is_clear = store_->front()->is_clear;
  if (is_clear) store_->take();
  return {squares_[square], is_clear};
}

const isa::LinkWord* StoreSender::next_word() const {
  const StoredWord* const front = store_->front();
  return front == nullptr ? nullptr : &front->word;
}

bool StoreSender::advance() {
  const bool is_last = store_->front()->is_last;
  store_->take();
  return is_last;
}

}  // namespace csgsim::pixel_square
