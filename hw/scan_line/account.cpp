#include "hw/scan_line/account.h"

#include <initializer_list>

#include "hw/scan_line/figures.h"

namespace csgsim::scan_line {

machines::Account account(const LineAccount& counted, const machines::Machine& machine, std::uint64_t clocks) {
  using enum LineActivity;
  const auto part = [](const char* name, const LineClocks& tally, std::initializer_list<LineActivity> shown) {
    return machines::part_of(name, tally, line_activity_names, shown);
  };
  const std::uint64_t cells = std::uint64_t{machine.array.width} * machines::own<Figures>(machine).chains;
  return {.counts = {{"lines", counted.lines},
                     {"packets", counted.packets},
                     {"most_packets", counted.max_packets},
                     {"line_budget", counted.line_budget},
                     {"late_lines", counted.late_lines},
                     {"link_words", counted.link_words},
                     {"entry_clocks", counted.entry_clocks},
                     {"refresh_clocks", counted.refresh_clocks},
                     {"fill_clocks", counted.fill_clocks},
                     {"drain_clocks", counted.drain_clocks},
                     {"busy_cells", counted.busy_cells}},
          .shares = {{"mean_packets", counted.packets, counted.lines},
                     {"cell_utilisation", counted.busy_cells, cells * clocks}},
          .parts = {part("host", counted.host, {sorting, updating, preparing, starting, waiting_for_link, done}),
                    part("link", counted.link, {sending, latency, waiting_for_host, waiting_for_entry, done}),
                    part("entry", counted.entry, {entering, waiting_for_link, waiting_for_refresh, done}),
                    part("refresh", counted.refresh, {showing, waiting_for_line, done})}};
}

}  // namespace csgsim::scan_line
