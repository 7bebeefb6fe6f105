#include "hw/scan_line/account.h"

#include <initializer_list>

#include "hw/scan_line/figures.h"

namespace csgsim::scan_line {

machines::Account account(const LineAccount& counts, const machines::Machine& machine, std::uint64_t frame_clocks) {
  using enum LineActivity;
  const auto part = [](const char* name, const LineClocks& tally, std::initializer_list<LineActivity> shown) {
    return machines::part_account(name, tally, line_activity_names, shown);
  };
  const std::uint64_t cells = std::uint64_t{machine.array.width} * machines::kind_figures<Figures>(machine).chains;
  return {.counts = {{"lines", counts.lines},
                     {"packets", counts.packets},
                     {"most_packets", counts.max_packets},
                     {"line_budget", counts.line_budget},
                     {"late_lines", counts.late_lines},
                     {"link_words", counts.link_words},
                     {"entry_clocks", counts.entry_clocks},
                     {"refresh_clocks", counts.refresh_clocks},
                     {"fill_clocks", counts.fill_clocks},
                     {"drain_clocks", counts.drain_clocks},
                     {"busy_cells", counts.busy_cells}},
          .shares = {{"mean_packets", counts.packets, counts.lines},
                     {"cell_utilisation", counts.busy_cells, cells * frame_clocks}},
          .parts = {part("host", counts.host, {sorting, updating, preparing, starting, waiting_for_link, done}),
                    part("link", counts.link, {sending, latency, waiting_for_host, waiting_for_entry, done}),
                    part("entry", counts.entry, {entering, waiting_for_link, waiting_for_refresh, done}),
                    part("refresh", counts.refresh, {showing, waiting_for_line, done})}};
}

}  // namespace csgsim::scan_line
