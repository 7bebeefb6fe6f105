#include "hw/bit_serial_memory/timing.h"
#include "tests/support/test.h"

// The reference is a rank that records the clock of each activation, after the table in
// docs/machines/bit-serial-memory.md. The implementation moves between states and counts from the last activation.

using namespace csgsim;
using bit_serial_memory::CommandClocks;
using bit_serial_memory::Figures;
using bit_serial_memory::RankTiming;
using bit_serial_memory::RowCommand;
using bit_serial_memory::RowCommands;
using bit_serial_memory::RowOp;
using bit_serial_memory::Slots;

namespace {

constexpr auto all_ops =
    std::to_array<RowOp>({RowOp::copy, RowOp::activate, RowOp::latch, RowOp::read, RowOp::write, RowOp::logic,
                          RowOp::leaf, RowOp::leaf_copy, RowOp::receive, RowOp::send, RowOp::wired_or});

class PlainRank {
 public:
  PlainRank(const Figures& figures, const Slots& slots, std::int64_t begin)
      : figures_(figures), slots_(slots), free_(slots.banks, begin), bus_(begin), due_(figures.rank.refresh_interval) {}

  void take(RowOp op) {
    if (op == RowOp::logic || op == RowOp::leaf || op == RowOp::wired_or) {
      for (std::int64_t& free : free_) free += of_gates(op);
      return;
    }
    if (op != RowOp::write && figures_.rank.refresh_interval > 0) refresh_if_due();
    for (std::uint64_t slot = 0; slot < slots_.count(); ++slot) carry_out(op, slot);
  }

  /// Clock at which the rank is back in its initial state.
  [[nodiscard]] std::int64_t over() const {
    std::int64_t clock = closed();
    if (!activations_.empty()) clock = std::max(clock, activations_.back() + figures_.rank.activation_gap);
    for (std::size_t i = activations_.size(); i > 0 && i + 4 > activations_.size(); --i)
      clock = std::max(clock, activations_[i - 1] + figures_.rank.window);
    return clock;
  }

  [[nodiscard]] std::uint64_t refreshes() const { return refreshes_; }
  [[nodiscard]] std::int64_t refreshing() const { return refreshing_; }

 private:
  [[nodiscard]] std::int64_t of_gates(RowOp op) const {
    const CommandClocks& clocks = figures_.command;
    if (op == RowOp::logic) return clocks.logic;
    return op == RowOp::leaf ? std::max(clocks.logic, clocks.leaf) : clocks.global_or;
  }

  [[nodiscard]] std::int64_t closed() const { return std::max(bus_, std::ranges::max(free_)); }

  [[nodiscard]] std::int64_t allowed(std::int64_t earliest) const {
    std::int64_t clock = earliest;
    const std::size_t count = activations_.size();
    if (count >= 1) clock = std::max(clock, activations_[count - 1] + figures_.rank.activation_gap);
    if (count >= 4) clock = std::max(clock, activations_[count - 4] + figures_.rank.window);
    return clock;
  }

  std::int64_t activate(std::int64_t earliest) {
    activations_.push_back(allowed(earliest));
    return activations_.back();
  }

  void carry_out(RowOp op, std::uint64_t slot) {
    const CommandClocks& clocks = figures_.command;
    const std::int64_t cycle = std::int64_t{clocks.restore} + clocks.precharge;
    std::int64_t& free = free_[slots_.bank(slot)];
    const std::int64_t first = activate(free);
    free = first + cycle;
    if (op == RowOp::copy) free = activate(first + clocks.second) + cycle;
    if (op == RowOp::leaf_copy) free = first + std::max<std::int64_t>(cycle, clocks.leaf);
    if (op != RowOp::receive && op != RowOp::send) return;
    const std::uint32_t bits_a_clock = std::min(figures_.bus_bits * figures_.chips, figures_.plane_bits);
    const std::uint64_t columns = std::min(slots_.row_columns, slots_.pixels - slot * slots_.row_columns);
    const auto transfer = static_cast<std::int64_t>((columns + bits_a_clock - 1) / bits_a_clock);
    bus_ = std::max(bus_, first + clocks.column) + transfer;
    free = std::max(first + clocks.restore, bus_ + clocks.recovery) + clocks.precharge;
  }

  /// All banks close once for all due refreshes; everything else is delayed.
  void refresh_if_due() {
    const std::int64_t now = allowed(free_.front());
    if (now < due_) return;
    std::int64_t taken = std::max(closed(), now) - now;
    for (; due_ <= now + taken; due_ += figures_.rank.refresh_interval) {
      taken += figures_.rank.refresh;
      ++refreshes_;
    }
    for (std::int64_t& free : free_) free += taken;
    for (std::int64_t& activation : activations_) activation += taken;
    bus_ += taken;
    refreshing_ += taken;
  }

  const Figures& figures_;
  const Slots slots_;
  std::vector<std::int64_t> free_;  ///< first free clock of each bank
  std::vector<std::int64_t> activations_;
  std::int64_t bus_;
  std::int64_t due_;
  std::int64_t refreshing_ = 0;
  std::uint64_t refreshes_ = 0;
};

class Random {
 public:
  explicit Random(std::uint64_t seed) : random_(seed) {}

  std::uint32_t of(std::uint32_t least, std::uint32_t most) {
    return least + static_cast<std::uint32_t>(random_() % (most - least + 1));
  }

  Figures figures() {
    Figures figures;
    figures.chips = of(1, 3);
    figures.row_bits = of(8, 40);
    figures.banks = of(1, 9);
    figures.bus_bits = of(1, 9);
    figures.plane_bits = of(1, 30);
    figures.command = {.restore = of(1, 40),
                       .precharge = of(1, 20),
                       .second = of(1, 60),
                       .logic = of(1, 9),
                       .column = of(1, 60),
                       .recovery = of(0, 30),
                       .leaf = of(1, 90),
                       .global_or = of(1, 30)};
    figures.rank = {.activation_gap = of(1, 12), .window = of(0, 90)};
    return figures;
  }

  /// The last slot may be only partly filled with pixels.
  Slots slots(const Figures& figures, std::uint32_t most) {
    const std::uint64_t columns = std::uint64_t{figures.chips} * figures.row_bits;
    return {of(1, most) * columns - of(0, 7), columns, figures.banks};
  }

  RowCommands commands(std::uint32_t count) {
    RowCommands all;
    for (std::uint32_t i = 0; i < count; ++i)
      all.push_back({.op = all_ops.at(of(0, static_cast<std::uint32_t>(all_ops.size()) - 1))});
    return all;
  }

 private:
  std::mt19937_64 random_;
};

std::int64_t plain_clocks(const Figures& figures, const Slots& slots, const RowCommands& commands) {
  PlainRank plain(figures, slots, 0);
  for (const RowCommand& command : commands) plain.take(command.op);
  return plain.over();
}

}  // namespace

TEST_CASE("random row commands take the clocks of a reference rank") {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Figures figures = random.figures();
    const Slots slots = random.slots(figures, 14);
    const RowCommands commands = random.commands(random.of(0, 12));
    RankTiming timing(figures, slots);
    const auto expected = static_cast<std::uint64_t>(plain_clocks(figures, slots, commands));
    CHECK(timing.clocks(commands) == expected);
    CHECK(timing.carry_out(commands, 1000) == 1000 + expected);
    CHECK(timing.clocks(commands) == expected);
    CHECK(timing.refreshes() == 0);
    CHECK(timing.refreshing() == 0);
  }
}

TEST_CASE("each row command takes the clocks of the documented table") {
  Figures figures;
  figures.row_bits = 64;
  figures.bus_bits = 10;
  figures.plane_bits = 100;
  figures.command = {.restore = 39,
                     .precharge = 16,
                     .second = 5,
                     .logic = 4,
                     .column = 32,
                     .recovery = 19,
                     .leaf = 70,
                     .global_or = 21};
  const auto clocks = [&](RowOp op) { return RankTiming(figures, {64, 64, 1}).clocks({{.op = op}}); };
  CHECK(clocks(RowOp::copy) == 5 + 39 + 16);
  for (const RowOp op : {RowOp::activate, RowOp::latch, RowOp::read, RowOp::write}) CHECK(clocks(op) == 39 + 16);
  CHECK(clocks(RowOp::logic) == 4);
  CHECK(clocks(RowOp::leaf) == 70);
  CHECK(clocks(RowOp::leaf_copy) == 70);
  CHECK(clocks(RowOp::wired_or) == 21);
  // 64 bits at 10 per clock.
  for (const RowOp op : {RowOp::receive, RowOp::send}) CHECK(clocks(op) == 32 + 7 + 19 + 16);
  // A bit from the trees takes at least the time of the gates and of its row.
  figures.command.leaf = 3;
  CHECK(clocks(RowOp::leaf) == 4);
  CHECK(clocks(RowOp::leaf_copy) == 39 + 16);
  // The row must be restored even if its bits are transferred earlier.
  figures.command.column = 2;
  figures.command.recovery = 0;
  CHECK(clocks(RowOp::send) == 39 + 16);
  // A command ends when four activations are allowed again.
  figures.rank = {.activation_gap = 60, .window = 0};
  CHECK(clocks(RowOp::read) == 60);
  CHECK(clocks(RowOp::copy) == 60 + 60);
  figures.rank = {.activation_gap = 1, .window = 80};
  CHECK(clocks(RowOp::read) == 80);
  CHECK(clocks(RowOp::copy) == 5 + 80);
}

TEST_CASE("refreshes delay row commands as in a reference rank") {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Figures figures = random.figures();
    figures.rank.refresh = random.of(0, 30);
    figures.rank.refresh_interval = 2 * figures.rank.refresh + random.of(1, 300);
    const Slots slots = random.slots(figures, 9);
    RankTiming timing(figures, slots);
    const RowCommands commands = random.commands(20);
    const std::uint64_t begin = random.of(0, figures.rank.refresh_interval - 1);
    PlainRank plain(figures, slots, static_cast<std::int64_t>(begin));
    for (const RowCommand& command : commands) plain.take(command.op);
    CHECK(timing.carry_out(commands, begin) == static_cast<std::uint64_t>(plain.over()));
    CHECK(timing.refreshes() == plain.refreshes());
    CHECK(timing.refreshing() == static_cast<std::uint64_t>(plain.refreshing()));
  }
}

TEST_CASE("a rank's clocks match the reference after its table of states is full") {
  Random random(5);
  Figures figures = random.figures();
  figures.banks = 3;
  const Slots slots = random.slots(figures, 9);
  // Each additional gate before the next activation makes another state. The table holds 4096, which a command may
  // exceed.
  for (std::size_t gates = 4090; gates <= 4100; ++gates) {
    CAPTURE(gates);
    RowCommands commands = random.commands(3);
    commands.insert(commands.end(), gates, {.op = RowOp::logic});
    for (const RowCommand& command : random.commands(12)) commands.push_back(command);
    RankTiming timing(figures, slots);
    const auto expected = static_cast<std::uint64_t>(plain_clocks(figures, slots, commands));
    CHECK(timing.clocks(commands) == expected);
    CHECK(timing.clocks(commands) == expected);
    const RowCommands few = random.commands(5);
    CHECK(timing.clocks(few) == static_cast<std::uint64_t>(plain_clocks(figures, slots, few)));
  }
}

TEST_CASE("due refreshes of a rank run one after the other before a command begins") {
  Figures figures;
  figures.rank.refresh_interval = 100;
  figures.rank.refresh = 40;
  struct Row {
    std::uint64_t free;
    std::uint64_t ready;
    std::uint64_t begins;
    std::uint64_t refreshes;
  };
  const std::array<Row, 8> rows{{
      {0, 99, 99, 0},
      {99, 0, 99, 0},
      {0, 100, 140, 1},   // due at the start of the command
      {100, 0, 140, 1},   // the same
      {30, 150, 150, 1},  // refresh ends at 140
      {0, 139, 140, 1},
      {0, 250, 250, 2},  // refreshes at 100 and 200; the second ends at 240
      {250, 0, 370, 3},  // ends at 290, 330 (after 300) and 370
  }};
  for (const Row& row : rows) {
    CAPTURE(row.free);
    CAPTURE(row.ready);
    RankTiming timing(figures, {64, 64, 1});
    CHECK(timing.begin(row.free, row.ready) == row.begins);
    CHECK(timing.refreshes() == row.refreshes);
    CHECK(timing.refreshing() == 40 * row.refreshes);
  }
  figures.rank.refresh_interval = 0;
  RankTiming never(figures, {64, 64, 1});
  CHECK(never.begin(1000, 7) == 1000);
  CHECK(never.refreshes() == 0);
}

TEST_CASE("each row command has its number of activations and refresh restriction") {
  struct Row {
    RowOp op;
    std::string name;
    unsigned activations;
    bool begins_closed;
  };
  const std::vector<Row> rows{
      {RowOp::copy, "AAP", 2, true},   {RowOp::activate, "AP", 1, true},      {RowOp::latch, "LATCH", 1, true},
      {RowOp::read, "READ", 1, true},  {RowOp::write, "WRITE", 1, false},     {RowOp::logic, "LOGIC", 0, false},
      {RowOp::leaf, "LEAF", 0, false}, {RowOp::leaf_copy, "LEAFAP", 1, true}, {RowOp::receive, "RECEIVE", 1, true},
      {RowOp::send, "SEND", 1, true},  {RowOp::wired_or, "OR", 0, false}};
  CHECK(rows.size() == bit_serial_memory::row_op_count);
  for (const Row& row : rows) {
    CAPTURE(row.name);
    CHECK(std::string(name_of(row.op)) == row.name);
    CHECK(activations(row.op) == row.activations);
    CHECK(begins_closed(row.op) == row.begins_closed);
  }
}
