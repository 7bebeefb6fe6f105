#include "hw/pixel_square/account.h"

#include <string>
#include <utility>

namespace csgsim::pixel_square {

namespace {

/// Account of a unit that neither refreshes nor waits for the ring.
machines::PartAccount part(std::string name, const SquareClocks& clocks) {
  using enum SquareActivity;
  return machines::part_of(
      std::move(name), clocks, square_activity_names,
      {working, waiting_for_host, waiting_for_divider, waiting_for_renderer, waiting_for_frame_buffer, done});
}

machines::PartAccount processor(std::string name, const SquareClocks& clocks) {
  using enum SquareActivity;
  return machines::part_of(std::move(name), clocks, square_activity_names,
                           {working, waiting_for_host, waiting_for_renderer, waiting_for_ring, done});
}

machines::PartAccount ring(const SquareClocks& clocks) {
  return machines::part_of("ring", clocks, square_activity_names,
                           {SquareActivity::working, SquareActivity::waiting_for_divider});
}

machines::PartAccount frame_buffer(const SquareClocks& clocks) {
  using enum SquareActivity;
  return machines::part_of("frame buffer", clocks, square_activity_names,
                           {working, waiting_for_host, waiting_for_divider, waiting_for_renderer,
                            waiting_for_frame_buffer, done, refreshing});
}

/// Adds the units that distribute the squares, and those that supply them.
void add_front(const SquareAccount& counted, machines::Account& account) {
  if (!counted.ring) account.parts.push_back(part("host", counted.host));
  for (std::size_t i = 0; i < counted.processors.size(); ++i)
    account.parts.push_back(processor("processor " + std::to_string(i), counted.processors[i]));
  if (counted.ring) {
    account.parts.push_back(ring(counted.ring->clocks));
    account.counts.push_back({"ring_words", counted.ring->words});
    account.counts.push_back({"ring_full_clocks", counted.ring->full_clocks});
  }
  for (std::size_t i = 0; i < counted.dividers.size(); ++i) {
    const std::string name = counted.dividers.size() == 1 ? "divider" : "divider " + std::to_string(i);
    account.parts.push_back(part(name, counted.dividers[i]));
  }
  if (counted.sender) account.parts.push_back(part("sender", *counted.sender));
}

/// Fraction of the renderers' clocks spent drawing.
machines::Share utilisation(const SquareAccount& counted) {
  machines::Share share{.name = "renderer_utilisation"};
  for (const SquareClocks& renderer : counted.renderers) {
    share.part += renderer.of(SquareActivity::working);
    share.whole += renderer.total();
  }
  return share;
}

}  // namespace

SquareClocks complete_clocks(SquareClocks counted, SquareActivity rest, std::uint64_t clocks) {
  counted.add(rest, clocks - counted.total());
  return counted;
}

machines::Account account(const SquareAccount& counted) {
  machines::Account account{
      .counts = {{"squares_drawn", counted.squares_drawn}, {"squares_skipped", counted.squares_skipped}},
      .shares = {utilisation(counted)},
      .parts = {}};
  add_front(counted, account);
  for (std::size_t i = 0; i < counted.renderers.size(); ++i) {
    const std::string name = "renderer " + std::to_string(i);
    account.counts.push_back({"squares of " + name, counted.renderer_squares[i]});
    account.parts.push_back(part(name, counted.renderers[i]));
  }
  account.parts.push_back(frame_buffer(counted.frame_buffer));
  return account;
}

}  // namespace csgsim::pixel_square
