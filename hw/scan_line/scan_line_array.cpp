#include "hw/scan_line/scan_line_array.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "hw/scan_line/figures.h"
#include "hw/scan_line/make.h"
#include "hw/scan_line/taps.h"
#include "hw/scan_line/timing.h"
#include "hw/systemc/kernel.h"
#include "hw/wave/segments.h"

namespace csgsim::scan_line {

namespace {

const Figures& figures_of(const machines::Machine& machine) { return machines::own<Figures>(machine); }

/// A packet is accounted for when its last beat enters, and the account is read when that has left the last cell.
int most_accounts(const machines::Machine& machine) { return static_cast<int>(machine.array.width) + 2; }

/// By index: two iterators of SystemC 2.3's sc_vector do not compare in C++20, since `a != b` and `b != a` fit equally.
template <class Module, class Act>
void for_each(sc_core::sc_vector<Module>& modules, const Act& act) {
  for (std::size_t i = 0; i < modules.size(); ++i) act(modules[i]);
}

/// The picture in row order, of lines in the Program's order.
std::vector<std::uint32_t> picture_of(const isa::Program& program,
                                      const std::vector<std::vector<std::uint32_t>>& lines) {
  std::vector<std::uint32_t> picture(std::size_t{program.shape.width} * program.shape.height);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::copy(lines[i].begin(), lines[i].end(),
              &picture[std::size_t{program.segments[i].region.y} * program.shape.width]);
  }
  return picture;
}

}  // namespace

ScanLineArray::ScanLineArray(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      machine_(machine),
      clock_("clock", systemc::period_of(machine)),
      lines_("lines"),
      words_("words"),
      entry_("entry", figures_of(machine).chains),
      entering_("entering", figures_of(machine).chains),
      refresh_("refresh", figures_of(machine).chains),
      accounts_("accounts"),
      host_("host", figures_of(machine)),
      links_("links"),
      queues_("queues"),
      chains_("chains"),
      collector_("collector", figures_of(machine).chains) {
  SC_HAS_PROCESS(ScanLineArray);
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);

  const std::uint32_t chains = figures_of(machine).chains;
  const CellShape cell = cell_shape(figures_of(machine));
  lines_.init(chains, [](const char* part, std::size_t) { return new sc_core::sc_fifo<std::uint32_t>(part, 1); });
  words_.init(chains, [&machine](const char* part, std::size_t) {
    return new sc_core::sc_fifo<isa::LinkWord>(part, static_cast<int>(machine.link.fifo_depth));
  });
  accounts_.init(chains, [&machine](const char* part, std::size_t) {
    return new sc_core::sc_fifo<EntryAccount>(part, most_accounts(machine));
  });
  links_.init(chains, [&machine](const char* part, std::size_t) { return new ChainLink(part, machine.link); });
  queues_.init(chains, [&machine](const char* part, std::size_t chain) {
    return new PacketQueue(part, machine, static_cast<std::uint32_t>(chain));
  });
  chains_.init(chains, [&](const char* part, std::size_t) { return new CellChain(part, machine.array, cell); });

  for (std::size_t i = 0; i < chains; ++i) {
    host_.lines[i](lines_[i]);
    links_[i].clock(clock_);
    links_[i].lines(lines_[i]);
    links_[i].words(words_[i]);

    queues_[i].clock(clock_);
    queues_[i].link(words_[i]);
    queues_[i].entry(entry_[i]);
    queues_[i].busy(entering_[i]);
    queues_[i].accounts(accounts_[i]);
    queues_[i].retirement(retirement_);

    chains_[i].clock(clock_);
    chains_[i].entry(entry_[i]);
    chains_[i].refresh(refresh_[i]);
    chains_[i].accounts(accounts_[i]);
    chains_[i].retirement(retirement_);

    collector_.refresh[i](refresh_[i]);
    collector_.entering[i](entering_[i]);
  }
  host_.clock(clock_);
  collector_.clock(clock_);
  collector_.frames(frames_);

  SC_METHOD(on_done);
  dont_initialize();
  sensitive << frames_;
}

/// Gives control back to who started the simulation, when all that belongs to this edge has happened.
void ScanLineArray::on_done() { sc_core::sc_pause(); }

systemc::RunReport ScanLineArray::run(const isa::Program& program, systemc::RunListener& listener) {
  const isa::FrameHeader header = isa::frame_header(program);
  const PictureLines frame{
      .lines = program.segments, .extents = program.extents, .colour = header.colour, .background = header.background};
  draw(frame, listener);
  systemc::RunReport report{.clocks = collector_.clocks(),
                            .answers = {},
                            .account = account(counted(), machine_, collector_.clocks()),
                            .shown_clocks = collector_.clocks(),
                            .interval_clocks = interval(frame)};
  if (header.colour.width > 0) report.picture = picture_of(program, collector_.lines());
  return report;
}

void ScanLineArray::draw(const PictureLines& frame, systemc::RunListener& listener) {
  if (sc_core::sc_get_status() == sc_core::SC_ELABORATION) sc_core::sc_start(sc_core::SC_ZERO_TIME);
  retirement_.begin(listener);
  host_.begin(frame);
  for (std::size_t i = 0; i < links_.size(); ++i)
    links_[i].begin(frame, (frame.lines.size() + links_.size() - 1 - i) / links_.size());
  for_each(queues_, [&](PacketQueue& queue) { queue.begin(frame); });
  for_each(chains_, [&](CellChain& chain) { chain.begin(frame.pixels()); });
  collector_.begin(frame);
  sc_core::sc_start();
  retirement_.rethrow();
}

/// The frame after begins when all marks have entered, and so late that none of its own waits for one of these.
std::uint64_t ScanLineArray::interval(const PictureLines& frame) const {
  std::uint64_t clocks = 0;
  for (const PacketQueue& queue : queues_) {
    const EntryCounts& counts = queue.counts();
    if (counts.clocks == 0) continue;
    const std::uint64_t free = counts.clocks + mark_spacing(frame.pixels());
    clocks = std::max({clocks, counts.clocks, free - std::min(free, counts.first_mark)});
  }
  return clocks;
}

LineAccount ScanLineArray::counted() const {
  const std::size_t last = collector_.last_chain();
  LineAccount account{.lines = collector_.lines().size(),
                      .line_budget = line_budget(machine_, static_cast<std::uint32_t>(collector_.lines().size())),
                      .drain_clocks = collector_.drain_clocks(),
                      .host = host_.clocks(),
                      .link = links_[last].clocks(),
                      .entry = queues_[last].clocks(),
                      .refresh = collector_.clocks(last)};
  for (const ChainLink& link : links_) account.link_words += link.sent();
  for (const PacketQueue& queue : queues_) {
    const EntryCounts& counts = queue.counts();
    account.packets += counts.packets;
    account.most_packets = std::max(account.most_packets, counts.most_packets);
    account.late_lines += counts.late_lines;
    account.entry_clocks += queue.clocks().of(LineActivity::entering);
    account.refresh_clocks += queue.clocks().of(LineActivity::waiting_for_refresh);
  }
  for (const CellChain& chain : chains_) {
    const std::uint64_t fill = chain.fill_clocks();
    if (fill > 0 && (account.fill_clocks == 0 || fill < account.fill_clocks)) account.fill_clocks = fill;
    account.busy_cells += chain.chain().busy_cells();
  }
  return account;
}

std::vector<wave::Tap> ScanLineArray::taps(const isa::Program& program, const wave::Request& request) const {
  wave::check_no_trees(request);
  std::vector<wave::Tap> taps = host_taps(host_, program);
  const auto add = [&](std::vector<wave::Tap> more) { wave::add(std::move(more), taps); };
  const WordShape shape{f_bits(cell_shape(figures_of(machine_))), machine_.evaluator_degree,
                        figures_of(machine_).network == Network::chain};
  std::vector<ChainParts> chains;
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    chains.push_back({links_[i], words_[i], queues_[i], entry_[i], chains_[i], refresh_[i], collector_, i});
    add(chain_taps(chains_.size() == 1 ? "" : "_" + std::to_string(i), chains.back(), program, shape));
  }
  for (const wave::Pixel pixel : request.pixels) add(cell_taps(pixel, chains, program, shape));
  return taps;
}

std::unique_ptr<systemc::ClockedMachine> make_machine(const machines::Machine& machine) {
  return std::make_unique<ScanLineArray>("scan_line", machine);
}

}  // namespace csgsim::scan_line
