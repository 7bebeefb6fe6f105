#include "hw/process/process.h"

#include <array>
#include <utility>

#include "hw/machines/figure_changes.h"
#include "hw/machines/figure_file.h"

namespace csgsim::process {

namespace {

constexpr std::string_view words[] = {"name", "description"};

/// Names of machines::LogicFamily, in its order.
constexpr std::string_view families[] = {"cmos", "nmos"};

/// A parameter and the member that stores it.
struct Row {
  std::string_view key;
  std::string_view unit;
  std::int64_t least;
  std::int64_t most;
  std::uint64_t Process::*member;
  std::span<const std::string_view> names{};
};

constexpr auto rows = std::to_array<Row>({
    {"gate.delay", "ps", 1, 1'000'000, &Process::gate_delay},
    {"gate.fan_in", "inputs", 2, 64, &Process::gate_fan_in},
    {"gate.static_power", "pW", 0, 1'000'000'000, &Process::static_power},
    {"logic.family", "", 0, 1, &Process::family, families},
    {"logic.utilization", "%", 1, 100, &Process::utilization},
    {"supply.voltage", "mV", 1, 100'000, &Process::supply},
    {"register.delay", "ps", 1, 1'000'000, &Process::register_delay},
    {"register.energy", "aJ a bit", 0, 1'000'000'000'000, &Process::register_energy},
    {"adder.energy", "aJ a bit", 0, 1'000'000'000'000, &Process::adder_energy},
    {"clock.lines", "wires", 0, 16, &Process::clock_lines},
    {"memory.access", "ps", 1, 10'000'000, &Process::memory_access},
    {"memory.read_energy", "aJ a bit", 0, 1'000'000'000'000'000, &Process::memory_energy},
    {"memory.read_bits", "bits", 1, 1'000'000'000, &Process::memory_bits},
    {"memory.cell_transistors", "transistors", 1, 16, &Process::cell_transistors},
    {"memory.cell_area", "nm2", 1, 10'000'000'000'000, &Process::cell_area},
    {"memory.periphery", "%", 0, 10'000, &Process::periphery},
    {"memory.refresh_time", "ns", 0, 1'000'000'000'000, &Process::refresh_time},
    {"transistor.area", "nm2", 1, 1'000'000'000'000, &Process::transistor_area},
    {"wire.delay", "ps a mm", 0, 1'000'000, &Process::wire_delay},
    {"wire.capacitance", "fF a mm", 0, 100'000, &Process::wire_capacitance},
});

std::vector<machines::FigureForm> forms() {
  std::vector<machines::FigureForm> all;
  all.reserve(rows.size());
  for (const Row& row : rows) all.push_back({row.key, row.unit, row.least, row.most, row.names});
  return all;
}

Process read_figures(const machines::FigureFile& file) {
  Process process;
  process.name = file.text("name");
  process.description = file.text("description");
  for (machines::ReadFigure& read : file.figures(forms(), words)) {
    process.*rows[read.form].member = static_cast<std::uint64_t>(read.value);
    process.figures.push_back(std::move(read.figure));
  }
  return process;
}

}  // namespace

Process read_process(std::string_view text, std::string_view file, std::span<const std::string> changes) {
  return machines::read_changed(text, file, changes, [&](const toml::table& root, const std::string& spec) {
    return read_figures(machines::FigureFile(root, file, spec));
  });
}

}  // namespace csgsim::process
