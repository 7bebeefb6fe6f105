#include "hw/scan_line/scan_line_array.h"

#include <algorithm>
#include <cstddef>

#include "hw/machines/timing.h"
#include "hw/systemc/kernel.h"

namespace csgsim::scan_line {

namespace {

/// A packet is accounted for when its last word enters, and the account is read when that has left the last cell.
int most_accounts(const machines::Machine& machine) { return static_cast<int>(machine.array.width) + 2; }

/// By index: two iterators of SystemC 2.3's sc_vector do not compare in C++20, since `a != b` and `b != a` fit equally.
template <class Module, class Act>
void for_each(sc_core::sc_vector<Module>& modules, const Act& act) {
  for (std::size_t i = 0; i < modules.size(); ++i) act(modules[i]);
}

}  // namespace

ScanLineArray::ScanLineArray(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      machine_(machine),
      clock_("clock", kernel::period_of(machine), 0.5, kernel::period_of(machine)),
      entry_("entry", machine.scan_line.chains),
      entering_("entering", machine.scan_line.chains),
      refresh_("refresh", machine.scan_line.chains),
      departed_("departed", machine.scan_line.chains),
      accounts_("accounts"),
      queues_("queues"),
      chains_("chains"),
      retirements_("retirements", machine.scan_line.chains),
      collector_("collector", machine.scan_line.chains) {
  SC_HAS_PROCESS(ScanLineArray);
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);

  const std::uint32_t chains = machine.scan_line.chains;
  accounts_.init(chains, [&machine](const char* part, std::size_t) {
    return new sc_core::sc_fifo<EntryAccount>(part, most_accounts(machine));
  });
  queues_.init(chains, [&machine](const char* part, std::size_t chain) {
    return new PacketQueue(part, machine, static_cast<std::uint32_t>(chain));
  });
  chains_.init(chains, [&machine](const char* part, std::size_t) {
    return new CellChain(part, machine.array, machine.scan_line.word_bits);
  });

  for (std::size_t i = 0; i < chains; ++i) {
    queues_[i].clock(clock_);
    queues_[i].entry(entry_[i]);
    queues_[i].busy(entering_[i]);
    queues_[i].accounts(accounts_[i]);

    chains_[i].clock(clock_);
    chains_[i].entry(entry_[i]);
    chains_[i].refresh(refresh_[i]);
    chains_[i].departed(departed_[i]);

    retirements_[i].departed(departed_[i]);
    retirements_[i].accounts(accounts_[i]);
    retirements_[i].exit(chains_[i].exit);

    collector_.refresh[i](refresh_[i]);
    collector_.entering[i](entering_[i]);
  }
  collector_.clock(clock_);
  collector_.frames(frames_);

  SC_METHOD(on_done);
  dont_initialize();
  sensitive << frames_;
}

/// Gives control back to who started the simulation, when all that belongs to this edge has happened.
void ScanLineArray::on_done() { sc_core::sc_pause(); }

RunReport ScanLineArray::run(const Frame& frame) {
  if (sc_core::sc_get_status() == sc_core::SC_ELABORATION) sc_core::sc_start(sc_core::SC_ZERO_TIME);
  for_each(queues_, [&](PacketQueue& queue) { queue.begin(frame); });
  for_each(chains_, [&](CellChain& chain) { chain.begin(frame.pixels()); });
  for_each(retirements_, [&](Retirement& retirement) { retirement.begin(*frame.listener); });
  collector_.begin(frame);
  sc_core::sc_start();
  for_each(retirements_, [](Retirement& retirement) { retirement.rethrow(); });
  return {.clocks = collector_.clocks(), .account = account(frame)};
}

machines::LineAccount ScanLineArray::account(const Frame& frame) const {
  const auto height = static_cast<std::uint32_t>(frame.lines.size());
  machines::LineAccount account{.lines = collector_.lines().size(),
                                .line_budget = machines::line_budget(machine_, height),
                                .drain_clocks = collector_.drain_clocks()};
  for (const PacketQueue& queue : queues_) {
    const EntryCounts& counts = queue.counts();
    account.packets += counts.packets;
    account.most_packets = std::max(account.most_packets, counts.most_packets);
    account.late_lines += counts.late_lines;
    account.entry_clocks += counts.clocks;
    account.refresh_clocks += counts.waits;
  }
  for (const CellChain& chain : chains_) {
    const std::uint64_t fill = chain.fill_clocks();
    if (fill > 0 && (account.fill_clocks == 0 || fill < account.fill_clocks)) account.fill_clocks = fill;
    account.busy_cells += chain.chain().busy_cells();
  }
  return account;
}

}  // namespace csgsim::scan_line
