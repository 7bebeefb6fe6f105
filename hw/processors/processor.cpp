#include "hw/processors/processor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "hw/machines/figure_changes.h"
#include "hw/machines/figure_file.h"

namespace csgsim::processors {

namespace {

constexpr std::string_view words[] = {"name", "description"};
constexpr std::int64_t max_clocks = 1'000'000;
constexpr std::int64_t max_hz = 10'000'000'000;
constexpr std::int64_t min_factor = 100;
constexpr std::int64_t max_factor = 100'000;
constexpr std::int64_t max_dollars = 10'000'000;
constexpr double thousandths = 1000;

/// A parameter and how a processor stores it.
struct Row {
  std::string key;
  std::string_view unit;
  std::int64_t least;
  std::int64_t most;
  std::string_view meaning;
  void (*store)(Processor& processor, std::size_t kind, std::int64_t value);
  std::size_t kind = 0;  ///< kind of operation for a price, of program for a compiler factor
};

void store_price(Processor& processor, std::size_t kind, std::int64_t value) {
  processor.prices[kind] = static_cast<std::uint32_t>(value);
}

void store_factor(Processor& processor, std::size_t program, std::int64_t value) {
  processor.compiler_factors[program] = static_cast<std::uint32_t>(value);
}

struct FactorRow {
  Compiled program;
  const char* key;
  const char* meaning;
};

/// Rows in the order of the enumerators.
constexpr std::array factor_rows{
    FactorRow{Compiled::general, "compiler.factor",
              "clocks of a compiled program per thousand clocks of a hand-written one"},
    FactorRow{Compiled::standard, "compiler.standard",
              "clocks of the compiled standard traversal per thousand clocks of the hand-written one"},
    FactorRow{Compiled::early_out, "compiler.early_out",
              "clocks of the compiled traversal with early out per thousand clocks of the hand-written one"},
    FactorRow{Compiled::positional, "compiler.positional",
              "clocks of compiled positional coding per thousand clocks of hand-written code"},
    FactorRow{Compiled::status, "compiler.status",
              "clocks of the compiled status tree per thousand clocks of the hand-written one"},
    FactorRow{Compiled::bit_parallel, "compiler.bit_parallel",
              "clocks of the compiled bit-parallel methods per thousand clocks of the hand-written ones"}};
static_assert(factor_rows.size() == compiled_kinds);

std::vector<Row> make_rows() {
  std::vector<Row> rows{
      {"clock.frequency", "Hz", 1, max_hz, "clocks per second",
       [](Processor& one, std::size_t, std::int64_t value) { one.clock_hz = static_cast<std::uint64_t>(value); }},
      {"memory.price", "dollars a Mbyte", 1, max_dollars, "price of memory in the year of the processor",
       [](Processor& one, std::size_t, std::int64_t value) { one.memory_price = static_cast<std::uint32_t>(value); }}};
  for (const FactorRow& factor : factor_rows)
    rows.push_back({factor.key, "thousandths", min_factor, max_factor, factor.meaning, store_factor,
                    static_cast<std::size_t>(factor.program)});
  for (std::size_t kind = 0; kind < operation_kinds; ++kind)
    rows.push_back({fmt::format("price.{}", operation_rows[kind].name), "clocks", 0, max_clocks,
                    operation_rows[kind].meaning, store_price, kind});
  return rows;
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all = make_rows();
  return all;
}

std::vector<machines::FigureForm> forms() {
  std::vector<machines::FigureForm> all;
  all.reserve(rows().size());
  for (const Row& row : rows()) all.push_back({row.key, row.unit, row.least, row.most});
  return all;
}

Processor read_figures(const machines::FigureFile& file) {
  Processor processor;
  processor.name = file.text("name");
  processor.description = file.text("description");
  for (machines::ReadFigure& read : file.figures(forms(), words)) {
    const Row& row = rows()[read.form];
    row.store(processor, row.kind, read.value);
    processor.figures.push_back(std::move(read.figure));
  }
  return processor;
}

}  // namespace

Processor read_processor(std::string_view text, std::string_view file, std::span<const std::string> changes) {
  return machines::read_changed(text, file, changes, [&](const toml::table& root, const std::string& spec) {
    return read_figures(machines::FigureFile(root, file, spec));
  });
}

std::string_view meaning_of_figure(std::string_view key) {
  const auto found = std::ranges::find(rows(), key, &Row::key);
  if (found == rows().end()) throw std::out_of_range(fmt::format("no processor has a parameter {}", key));
  return found->meaning;
}

std::uint64_t hand_written_clocks(const Operations& operations, const Processor& processor) {
  std::uint64_t sum = 0;
  for (std::size_t kind = 0; kind < operation_kinds; ++kind) sum += operations.counts[kind] * processor.prices[kind];
  return sum;
}

double clocks(const Operations& operations, const Processor& processor, Compiled program_class) {
  double sum = 0;
  for (std::size_t kind = 0; kind < operation_kinds; ++kind)
    sum += static_cast<double>(operations.counts[kind]) * processor.prices[kind];
  return sum * processor.compiler_factors[static_cast<std::size_t>(program_class)] / thousandths;
}

double seconds(const Operations& operations, const Processor& processor, Compiled program_class) {
  return clocks(operations, processor, program_class) / static_cast<double>(processor.clock_hz);
}

}  // namespace csgsim::processors
