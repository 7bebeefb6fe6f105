#include "hw/scan_line/scan_line_array.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "hw/scan_line/figures.h"
#include "hw/scan_line/kind.h"
#include "hw/scan_line/taps.h"
#include "hw/scan_line/timing.h"
#include "hw/systemc/kernel.h"
#include "hw/systemc/maker.h"
#include "hw/wave/segments.h"

namespace csgsim::scan_line {

namespace {

const Figures& figures_of(const machines::Machine& machine) { return machines::kind_figures<Figures>(machine); }

/// A packet is accounted for when its last beat enters; the account is read when that beat has left the last cell.
int max_accounts(const machines::Machine& machine) { return static_cast<int>(machine.array.width) + 2; }

/// Iterates by index: iterators of SystemC 2.3's sc_vector do not compare in C++20, since `a != b` and `b != a` are
/// ambiguous.
template <class Modules, class Act>
void for_each(Modules& modules, const Act& act) {
  for (std::size_t i = 0; i < modules.size(); ++i) act(modules[i]);
}

PictureLines lines_of(const isa::Program& program) {
  const isa::FrameHeader header = isa::frame_header(program);
  return {
      .lines = program.segments, .extents = program.extents, .colour = header.colour, .background = header.background};
}

/// The picture in row order, from lines in the Program's order.
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
      through_("through", figures_of(machine).chains),
      host_("host", figures_of(machine)),
      links_("links"),
      queues_("queues"),
      chains_("chains"),
      collector_("collector", figures_of(machine).chains),
      retirements_("retirements", figures_of(machine).chains) {
  SC_HAS_PROCESS(ScanLineArray);
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);

  const std::uint32_t chains = figures_of(machine).chains;
  const CellShape cell = cell_shape(figures_of(machine));
  lines_.init(chains, [](const char* part, std::size_t) { return new sc_core::sc_fifo<std::uint32_t>(part, 1); });
  words_.init(chains, [&machine](const char* part, std::size_t) {
    return new sc_core::sc_fifo<isa::LinkWord>(part, static_cast<int>(machine.link.fifo_depth));
  });
  accounts_.init(chains, [&machine](const char* part, std::size_t) {
    return new sc_core::sc_fifo<EntryAccount>(part, max_accounts(machine));
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
    queues_[i].through(through_[i]);
    queues_[i].retirement(retirements_[i]);

    chains_[i].clock(clock_);
    chains_[i].entry(entry_[i]);
    chains_[i].refresh(refresh_[i]);
    chains_[i].accounts(accounts_[i]);
    chains_[i].retirement(retirements_[i]);

    collector_.refresh[i](refresh_[i]);
    collector_.entering[i](entering_[i]);
  }
  host_.clock(clock_);
  collector_.clock(clock_);
  collector_.frames(frames_);

  SC_METHOD(on_entered);
  dont_initialize();
  for_each(through_, [this](sc_core::sc_signal<std::uint64_t>& through) { sensitive << through; });

  SC_METHOD(on_shown);
  dont_initialize();
  sensitive << frames_;
}

/// Returns control to the caller of run_sequence() after all events of this edge.
void ScanLineArray::on_entered() {
  if (all_entered()) sc_core::sc_pause();
}

void ScanLineArray::on_shown() { sc_core::sc_pause(); }

bool ScanLineArray::all_entered() const {
  bool all = true;
  for_each(queues_, [&](const PacketQueue& queue) { all = all && queue.all_marks_entered(); });
  return all;
}

/// Clock edges since the machine was built.
std::uint64_t ScanLineArray::edges() const { return systemc::edges(clock_.period()); }

systemc::RunReport ScanLineArray::run(const isa::Program& program, systemc::RunListener& listener) {
  systemc::RunListener* const listeners[] = {&listener};
  return std::move(run_sequence({&program, 1}, listeners).front());
}

std::vector<systemc::RunReport> ScanLineArray::run_sequence(std::span<const isa::Program> programs,
                                                            std::span<systemc::RunListener* const> listeners) {
  std::vector<systemc::RunReport> reports(programs.size());
  if (programs.empty()) return reports;
  systemc::elaborate();
  std::deque<systemc::GuardedListener> guarded;
  std::uint32_t pixels = 0;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const PictureLines frame = lines_of(programs[i]);
    if (frame.pixels() != pixels) {
      run_until_shown();
      clear(frame.pixels());
      pixels = frame.pixels();
    }
    const std::uint64_t start_clock = edges();
    begin(frame, guarded.emplace_back(*listeners[i]));
    run_until_entered();
    reports[i].interval_clocks = edges() - start_clock;
    showing_.push_back({&programs[i], &reports[i], entered()});
    collect();
  }
  run_until_shown();
  for (systemc::GuardedListener& listener : guarded) listener.rethrow();
  if (programs.size() == 1) reports.front().interval_clocks = time_lines(programs.front(), machine_).interval_clocks;
  return reports;
}

/// Empties the chains for lines of `line_pixels` pixels. All frames drawn must have been shown.
void ScanLineArray::clear(std::uint32_t line_pixels) {
  for_each(queues_, [](PacketQueue& queue) { queue.forget_mark(); });
  for_each(chains_, [line_pixels](CellChain& chain) { chain.clear(line_pixels); });
}

void ScanLineArray::begin(const PictureLines& frame, systemc::RunListener& listener) {
  host_.begin(frame);
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    const std::size_t lines = (frame.lines.size() + chains_.size() - 1 - i) / chains_.size();
    links_[i].begin(frame, lines);
    queues_[i].begin(frame);
    chains_[i].begin(lines);
    retirements_[i].begin(listener, lines);
  }
  collector_.begin(frame);
}

void ScanLineArray::run_until_entered() {
  while (!all_entered() && !systemc::is_stopped()) {
    systemc::run();
    collect();
  }
}

void ScanLineArray::run_until_shown() {
  while (!showing_.empty() && !systemc::is_stopped()) {
    systemc::run();
    collect();
  }
}

/// Frames are shown in the order in which they were drawn.
void ScanLineArray::collect() {
  for (; shown_ < frames_.read(); ++shown_) {
    const Showing& frame = showing_.front();
    const ShownFrame shown = collector_.pop_frame();
    systemc::RunReport& report = *frame.report;
    report.clocks = shown.clocks;
    report.shown_clocks = shown.clocks;
    report.account = account(make_account(frame.entered, shown), machine_, shown.clocks);
    if (isa::frame_header(*frame.program).colour.width > 0) report.picture = picture_of(*frame.program, shown.lines);
    showing_.pop_front();
  }
}

ScanLineArray::Entered ScanLineArray::entered() const {
  Entered entered{.host = host_.counter(), .chains = {}};
  for (std::size_t i = 0; i < chains_.size(); ++i)
    entered.chains.push_back({links_[i].counter(), links_[i].sent(), queues_[i].counter(), queues_[i].counts()});
  return entered;
}

/// Combines the counts of all units, and removes those that the chains have stored.
LineAccount ScanLineArray::make_account(const Entered& entered, const ShownFrame& shown) {
  const std::size_t last = shown.last_chain;
  const std::size_t lines = shown.lines.size();
  LineAccount account{.lines = lines,
                      .line_budget = line_budget(machine_, static_cast<std::uint32_t>(lines)),
                      .drain_clocks = shown.drain_clocks,
                      .host = entered.host.clocks_of(shown.clocks),
                      .link = entered.chains[last].link.clocks_of(shown.clocks),
                      .entry = entered.chains[last].entry.clocks_of(shown.clocks),
                      .refresh = shown.chains[last]};
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    const auto& [link, words, entry, counts] = entered.chains[i];
    account.link_words += words;
    account.packets += counts.packets;
    account.max_packets = std::max(account.max_packets, counts.max_packets);
    account.late_lines += counts.late_lines;
    const LineClocks at_entry = entry.clocks_of(shown.clocks);
    account.entry_clocks += at_entry.of(LineActivity::entering);
    account.refresh_clocks += at_entry.of(LineActivity::waiting_for_refresh);
    const CellCounts cells = chains_[i].pop_counts();
    if (cells.fill_clocks > 0 && (account.fill_clocks == 0 || cells.fill_clocks < account.fill_clocks))
      account.fill_clocks = cells.fill_clocks;
    account.busy_cells += cells.busy_cells;
  }
  return account;
}

std::vector<wave::Tap> ScanLineArray::taps(const isa::Program& program, const wave::Request& request) const {
  wave::check_no_tree_levels(request);
  std::vector<wave::Tap> taps = host_taps(host_, program);
  const auto add = [&](std::vector<wave::Tap> more) { wave::add(std::move(more), taps); };
  const WordShape shape{cell_shape(figures_of(machine_)), machine_.evaluator_degree,
                        figures_of(machine_).network == Network::chain};
  std::vector<ChainParts> chains;
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    chains.push_back({links_[i], words_[i], queues_[i], entry_[i], chains_[i], refresh_[i], collector_, i});
    add(chain_taps(chains_.size() == 1 ? "" : "_" + std::to_string(i), chains.back(), program, shape));
  }
  for (const wave::Pixel pixel : request.pixels) add(cell_taps(pixel, chains, program, shape));
  return taps;
}

}  // namespace csgsim::scan_line

namespace csgsim::systemc {

extern const Maker scan_line_maker{.kind = &scan_line::kind,
                                   .make = [](const machines::Machine& machine) -> std::unique_ptr<ClockedMachine> {
                                     return std::make_unique<scan_line::ScanLineArray>("scan_line", machine);
                                   }};

}  // namespace csgsim::systemc
