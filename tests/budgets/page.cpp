#include "tests/budgets/page.h"

#include "places.h"
#include "tests/support/test.h"

namespace csgsim::budgets {

namespace {

std::string with_commas(std::uint64_t value) {
  return value < 1000 ? fmt::format("{}", value) : fmt::format("{},{:03}", value / 1000, value % 1000);
}

}  // namespace

std::string row_of_page(const std::string& name) {
  std::ifstream page(std::string(CSGSIM_SOURCE_DIR) + "/docs/performance.md");
  const std::string begin = "| " + name + " |";
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with(begin)) return line.substr(begin.size());
  }
  return "(no such row)";
}

void check_row(const std::string& name, double published, std::uint64_t ours) {
  INFO("if the change is intended, run tests/budgets/table.py build/release/csgsim and update docs/performance.md");
  CHECK(row_of_page(name) == fmt::format(" {} | {} | {:.2f} |",
                                         with_commas(static_cast<std::uint64_t>(published + 0.5)), with_commas(ours),
                                         static_cast<double>(ours) / published));
}

}  // namespace csgsim::budgets
