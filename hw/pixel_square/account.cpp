#include "hw/pixel_square/account.h"

#include <string>
#include <utility>

namespace csgsim::pixel_square {

namespace {

/// Account of a unit that neither refreshes nor waits for the ring.
machines::PartAccount part(std::string name, const SquareClocks& clocks) {
  using enum SquareActivity;
  return machines::part_account(
      std::move(name), clocks, square_activity_names,
      {working, waiting_for_host, waiting_for_divider, waiting_for_renderer, waiting_for_frame_buffer, done});
}

machines::PartAccount processor(std::string name, const SquareClocks& clocks) {
  using enum SquareActivity;
  return machines::part_account(std::move(name), clocks, square_activity_names,
                                {working, waiting_for_host, waiting_for_renderer, waiting_for_ring, done});
}

machines::PartAccount ring(const SquareClocks& clocks) {
  return machines::part_account("ring", clocks, square_activity_names,
                                {SquareActivity::working, SquareActivity::waiting_for_divider});
}

machines::PartAccount frame_buffer(const SquareClocks& clocks) {
  using enum SquareActivity;
  return machines::part_account("frame buffer", clocks, square_activity_names,
                                {working, waiting_for_host, waiting_for_divider, waiting_for_renderer,
                                 waiting_for_frame_buffer, done, refreshing});
}

/// Adds the units that distribute the squares, and those that supply them.
void add_front(const SquareAccount& counts, machines::Account& account) {
  if (!counts.ring) account.parts.push_back(part("host", counts.host));
  for (std::size_t i = 0; i < counts.processors.size(); ++i)
    account.parts.push_back(processor("processor " + std::to_string(i), counts.processors[i]));
  if (counts.ring) {
    account.parts.push_back(ring(counts.ring->clocks));
    account.counts.push_back({"ring_words", counts.ring->words});
    account.counts.push_back({"ring_full_clocks", counts.ring->full_clocks});
  }
  for (std::size_t i = 0; i < counts.dividers.size(); ++i) {
    const std::string name = counts.dividers.size() == 1 ? "divider" : "divider " + std::to_string(i);
    account.parts.push_back(part(name, counts.dividers[i]));
  }
  if (counts.sender) account.parts.push_back(part("sender", *counts.sender));
}

/// Fraction of the renderers' clocks spent drawing.
machines::Share utilisation(const SquareAccount& counts) {
  machines::Share share{.name = "renderer_utilisation"};
  for (const SquareClocks& renderer : counts.renderers) {
    share.part += renderer.of(SquareActivity::working);
    share.whole += renderer.total();
  }
  return share;
}

}  // namespace

SquareClocks complete_clocks(SquareClocks counted_clocks, SquareActivity rest_activity, std::uint64_t frame_clocks) {
  counted_clocks.add(rest_activity, frame_clocks - counted_clocks.total());
  return counted_clocks;
}

machines::Account account(const SquareAccount& counts) {
  machines::Account account{
      .counts = {{"squares_drawn", counts.squares_drawn}, {"squares_skipped", counts.squares_skipped}},
      .shares = {utilisation(counts)},
      .parts = {}};
  add_front(counts, account);
  for (std::size_t i = 0; i < counts.renderers.size(); ++i) {
    const std::string name = "renderer " + std::to_string(i);
    account.counts.push_back({"squares of " + name, counts.renderer_squares[i]});
    account.parts.push_back(part(name, counts.renderers[i]));
  }
  account.parts.push_back(frame_buffer(counts.frame_buffer));
  return account;
}

}  // namespace csgsim::pixel_square
