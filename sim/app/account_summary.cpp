#include "sim/app/account_summary.h"

#include <fmt/format.h>

#include <string>

#include "sim/app/numbers.h"
#include "sim/observe/account_json.h"

namespace csgsim::app {

namespace {

void print_part(const std::string& part, const machines::SquareClocks& clocks, std::uint64_t frame) {
  fmt::print("  {:<16}", part);
  for (const std::uint64_t clock : clocks)
    fmt::print("{:>14}{:>6.1f} %", grouped(clock), 100.0 * sim::share(clock, frame));
  fmt::print("\n");
}

/// waiting_for_host as `wait: host`.
std::string heading(std::string_view activity) {
  constexpr std::string_view waiting = "waiting_for_";
  std::string text(activity.starts_with(waiting) ? activity.substr(waiting.size()) : activity);
  for (char& c : text) c = c == '_' ? ' ' : c;
  return activity.starts_with(waiting) ? "wait: " + text : text;
}

struct Printer {
  const sim::Report& report;

  void operator()(const std::monostate& /*whole*/) const {}

  void operator()(const machines::LineAccount& account) const {
    fmt::print("\n{:<18}{} in {}, {:.1f} a line, {} at most; {} of {} lines are late: more than {} clocks\n", "packets",
               grouped(account.packets), counted(account.lines, "line"),
               static_cast<double>(account.packets) / static_cast<double>(std::max<std::uint64_t>(account.lines, 1)),
               grouped(account.most_packets), grouped(account.late_lines), grouped(account.lines),
               grouped(account.line_budget));
    fmt::print("{:<18}{} entering packets, {} waiting for the refresh path, {} to fill, {} to drain\n", "chain clocks",
               grouped(account.entry_clocks), grouped(account.refresh_clocks), grouped(account.fill_clocks),
               grouped(account.drain_clocks));
    fmt::print("{:<18}{:.1f} % of the cells' clocks\n", "busy cells", 100.0 * sim::cell_utilisation(account, report));
  }

  void operator()(const machines::SquareAccount& account) const {
    fmt::print("\n{:<18}{} drawn, {} skipped; the renderers draw {:.1f} % of the time\n", "squares",
               grouped(account.squares_drawn), grouped(account.squares_skipped),
               100.0 * sim::renderer_utilisation(account));
    fmt::print("{:<18}", "part");
    for (const machines::SquareActivityInfo& activity : machines::square_activities)
      fmt::print("{:>22}", heading(activity.name));
    fmt::print("\n");
    print_part("host", account.host, report.result.clocks);
    print_part("divider", account.divider, report.result.clocks);
    for (std::size_t i = 0; i < account.renderers.size(); ++i)
      print_part(fmt::format("renderer {}", i), account.renderers[i], report.result.clocks);
    print_part("frame buffer", account.frame_buffer, report.result.clocks);
  }
};

}  // namespace

void print_account(const sim::Report& report) { std::visit(Printer{report}, report.result.account); }

}  // namespace csgsim::app
