#include "hw/machines/load.h"
#include "hw/pixel_square/account.h"
#include "tests/support/test.h"
#include "tests/unit/machines/square_timing.h"

// Tests of the clock account of pixel-square machines: clocks per part, and the busiest part.

using namespace csgsim;
using namespace csgsim::testing::squares;
using machines::ActivityClocks;
using machines::PartAccount;
using pixel_square::SquareAccount;
using pixel_square::SquareActivity;

namespace {

/// Clocks that differ per activity: `first` for the first one and one more for each that follows.
Clocks counting_from(std::uint64_t first) {
  Clocks clocks;
  for (std::uint64_t& one : clocks.clocks) one = first++;
  return clocks;
}

/// Clocks of a part that works for `clocks` and is idle for `rest`.
Clocks working(std::uint64_t clocks, std::uint64_t rest = 0) { return {clocks, 0, 0, 0, 0, rest}; }

/// One line per part and per activity with its clocks.
std::vector<std::string> parts_of(const machines::Account& account) {
  std::vector<std::string> lines;
  for (const PartAccount& part : account.parts) {
    lines.push_back(part.part + ":");
    for (const ActivityClocks& one : part.clocks)
      lines.back() += " " + std::string(one.activity) + " " + std::to_string(one.clocks);
  }
  return lines;
}

std::vector<std::string> counts_of(const machines::Account& account) {
  std::vector<std::string> lines;
  for (const machines::Count& count : account.counts) lines.push_back(count.name + " " + std::to_string(count.value));
  return lines;
}

std::vector<std::string> loads_of(const SquareAccount& counted) {
  std::vector<std::string> lines;
  for (const machines::Load& load : pixel_square::kind.loads({.account = pixel_square::account(counted)}))
    lines.push_back(load.part + " " + std::to_string(load.clocks));
  return lines;
}

}  // namespace

TEST_CASE("complete_clocks() adds a part's clocks without work to waiting or to done") {
  CHECK(pixel_square::complete_clocks(working(3, 4), SquareActivity::waiting_for_host, 20) ==
        Clocks{3, 13, 0, 0, 0, 4});
  CHECK(pixel_square::complete_clocks(working(3, 4), SquareActivity::done, 20) == Clocks{3, 0, 0, 0, 0, 17});
  CHECK(pixel_square::complete_clocks(working(3), SquareActivity::waiting_for_ring, 3) == working(3));
}

TEST_CASE("a host-divided machine's account lists host and renderers and frame buffer") {
  SquareAccount counted;
  counted.squares_drawn = 5;
  counted.squares_skipped = 6;
  counted.host = counting_from(10);
  counted.renderers = {counting_from(20), counting_from(30)};
  counted.renderer_squares = {2, 3};
  counted.frame_buffer = counting_from(40);
  const machines::Account account = pixel_square::account(counted);
  CHECK(counts_of(account) == std::vector<std::string>{"squares_drawn 5", "squares_skipped 6",
                                                       "squares of renderer 0 2", "squares of renderer 1 3"});
  CHECK(parts_of(account) ==
        std::vector<std::string>{
            "host: working 10 waiting_for_host 11 waiting_for_divider 12 waiting_for_renderer 13 "
            "waiting_for_frame_buffer 14 done 15",
            "renderer 0: working 20 waiting_for_host 21 waiting_for_divider 22 waiting_for_renderer 23 "
            "waiting_for_frame_buffer 24 done 25",
            "renderer 1: working 30 waiting_for_host 31 waiting_for_divider 32 waiting_for_renderer 33 "
            "waiting_for_frame_buffer 34 done 35",
            "frame buffer: working 40 waiting_for_host 41 waiting_for_divider 42 waiting_for_renderer 43 "
            "waiting_for_frame_buffer 44 done 45 refreshing 46"});
  // Eight activities each: 20 to 27 and 30 to 37.
  REQUIRE(account.shares.size() == 1);
  CHECK(account.shares[0] == machines::Share{"renderer_utilisation", 20 + 30, 8 * 20 + 28 + 8 * 30 + 28});
}

TEST_CASE("the account lists dividers and senders if the machine divides") {
  SquareAccount counted;
  counted.dividers = {working(7)};
  counted.sender = working(8);
  const auto names = [&] {
    std::vector<std::string> all;
    for (const std::string& line : parts_of(pixel_square::account(counted)))
      all.push_back(line.substr(0, line.find(" waiting")));
    return all;
  };
  CHECK(names() == std::vector<std::string>{"host: working 0", "divider: working 7", "sender: working 8",
                                            "frame buffer: working 0"});
  counted.dividers = {working(1), working(2), working(3)};
  CHECK(names() == std::vector<std::string>{"host: working 0", "divider 0: working 1", "divider 1: working 2",
                                            "divider 2: working 3", "sender: working 8", "frame buffer: working 0"});
  CHECK(pixel_square::account(counted).shares[0] == machines::Share{"renderer_utilisation", 0, 0});
}

TEST_CASE("the account lists processors and the ring instead of the host on a ring") {
  SquareAccount counted;
  counted.processors = {counting_from(10), counting_from(20)};
  counted.ring = {.clocks = counting_from(30), .words = 50, .full_clocks = 60};
  counted.renderers = {working(9)};
  counted.renderer_squares = {1};
  const machines::Account account = pixel_square::account(counted);
  CHECK(counts_of(account) == std::vector<std::string>{"squares_drawn 0", "squares_skipped 0", "ring_words 50",
                                                       "ring_full_clocks 60", "squares of renderer 0 1"});
  const std::vector<std::string> parts = parts_of(account);
  REQUIRE(parts.size() == 5);
  CHECK(parts[0] == "processor 0: working 10 waiting_for_host 11 waiting_for_renderer 13 waiting_for_ring 17 done 15");
  CHECK(parts[1] == "processor 1: working 20 waiting_for_host 21 waiting_for_renderer 23 waiting_for_ring 27 done 25");
  CHECK(parts[2] == "ring: working 30 waiting_for_divider 32");
  CHECK(parts[3].starts_with("renderer 0: working 9 "));
  CHECK(parts[4].starts_with("frame buffer: "));
}

TEST_CASE("of several equally busy parts the first is the one that limits the frame") {
  SquareAccount counted;
  counted.host = working(5, 90);
  counted.renderers = {working(10), working(30), working(20), working(30)};
  counted.renderer_squares = {1, 1, 1, 1};
  counted.frame_buffer = {6, 0, 0, 0, 0, 80, 7};
  CHECK(loads_of(counted) ==
        std::vector<std::string>{"link from the host 5", "divider 0", "sender 0", "renderer 1 30", "frame buffer 13"});
  counted.dividers = {working(3)};
  counted.sender = working(4);
  counted.renderers = {working(10)};
  CHECK(loads_of(counted) ==
        std::vector<std::string>{"link from the host 5", "divider 3", "sender 4", "renderer 0 10", "frame buffer 13"});
  counted.dividers = {working(3), working(0), working(8), working(1)};
  counted.renderers = {working(0)};
  CHECK(loads_of(counted) ==
        std::vector<std::string>{"link from the host 5", "divider 2 8", "sender 4", "renderer 0", "frame buffer 13"});
}

TEST_CASE("on a ring the loads have the busiest processor and the ring's full clocks") {
  SquareAccount counted;
  counted.processors = {working(4), working(6)};
  counted.ring = {.clocks = working(50), .words = 20, .full_clocks = 9};
  counted.renderers = {working(2), working(1)};
  counted.renderer_squares = {1, 0};
  counted.frame_buffer = working(3);
  CHECK(loads_of(counted) == std::vector<std::string>{"processor 1 6", "ring 9", "renderer 0 2", "frame buffer 3"});
}

TEST_CASE("the pixel-square kind reports the clocks and the account of its timing model") {
  const isa::Program program = make_program(3, {square(2, {}), square(2, {enable, set({0, 3})})});
  for (const Figures& figures : {Figures{.renderers = 2, .buffers = 2, .port_bits = 32, .port_fifo_depth = 8},
                                 on_a_ring({.port_fifo_depth = 8, .processors = 2, .ring_bits = 32})}) {
    const Machine machine = make_machine(2, figures);
    const Timing timing = time(program, machine);
    CHECK(machine.kind->time(program, machine, {}) ==
          machines::FrameTiming{.clocks = timing.clocks, .account = pixel_square::account(timing.account)});
  }
}