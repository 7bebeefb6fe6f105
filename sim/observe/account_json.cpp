#include "sim/observe/account_json.h"

#include <algorithm>
#include <numeric>

namespace csgsim::sim {

namespace {

using Json = nlohmann::ordered_json;

Json clocks_json(const machines::SquareClocks& clocks) {
  Json json = Json::object();
  for (std::size_t i = 0; i < clocks.size(); ++i) json[std::string(machines::square_activities[i].name)] = clocks[i];
  return json;
}

struct ToJson {
  const Report& report;

  Json operator()(const std::monostate& /*whole*/) const { return nullptr; }

  Json operator()(const machines::LineAccount& account) const {
    const double lines = static_cast<double>(std::max<std::uint64_t>(account.lines, 1));
    return {{"lines", account.lines},
            {"packets",
             {{"total", account.packets},
              {"mean", static_cast<double>(account.packets) / lines},
              {"max", account.most_packets}}},
            {"line_budget", account.line_budget},
            {"late_lines", account.late_lines},
            {"entry_clocks", account.entry_clocks},
            {"refresh_clocks", account.refresh_clocks},
            {"fill_clocks", account.fill_clocks},
            {"drain_clocks", account.drain_clocks},
            {"cell_utilisation", cell_utilisation(account, report)}};
  }

  Json operator()(const machines::SquareAccount& account) const {
    Json renderers = Json::array();
    for (std::size_t i = 0; i < account.renderers.size(); ++i)
      renderers.push_back({{"squares", account.renderer_squares[i]}, {"clocks", clocks_json(account.renderers[i])}});
    return {{"squares", {{"drawn", account.squares_drawn}, {"skipped", account.squares_skipped}}},
            {"host", clocks_json(account.host)},
            {"divider", clocks_json(account.divider)},
            {"renderers", renderers},
            {"frame_buffer", clocks_json(account.frame_buffer)},
            {"renderer_utilisation", renderer_utilisation(account)}};
  }
};

}  // namespace

nlohmann::ordered_json account_json(const Report& report) { return std::visit(ToJson{report}, report.result.account); }

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

double cell_utilisation(const machines::LineAccount& account, const Report& report) {
  const machines::Machine& machine = report.machine;
  return share(account.busy_cells,
               std::uint64_t{machine.array.width} * machine.scan_line.chains * report.result.clocks);
}

double renderer_utilisation(const machines::SquareAccount& account) {
  constexpr auto working = static_cast<std::size_t>(machines::SquareActivity::working);
  std::uint64_t drawing = 0;
  std::uint64_t all = 0;
  for (const machines::SquareClocks& renderer : account.renderers) {
    drawing += renderer[working];
    all += std::accumulate(renderer.begin(), renderer.end(), std::uint64_t{0});
  }
  return share(drawing, all);
}

}  // namespace csgsim::sim
