#include <fmt/format.h>

#include <optional>

#include "hw/base/text.h"
#include "tests/performance/report.h"

namespace csgsim::bench {

namespace {

/// Three digits that count.
std::string short_number(double value) { return fmt::format("{:.3g}", value); }

std::string milliseconds(double seconds) { return fmt::format("{:.4g}", seconds * 1e3); }

std::string speeds(const Results& results) {
  if (results.speeds.empty()) return {};
  std::string text = fmt::format(
      "## Runs\n\nA run alone, without start, reading and writing, {} pixels.\n\n"
      "| model | machine | level | clocks | simulated ms | wall ms | simulated s / wall s "
      "|\n|---|---|---|--:|--:|--:|--:|\n",
      results.settings.size);
  for (const Speed& row : results.speeds) {
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", printable(row.model), printable(row.machine), row.level,
                    row.clocks, milliseconds(row.simulated), milliseconds(row.wall), short_number(row.ratio()));
  }
  return text + fmt::format("\nThe last by `{}`, the others likewise.\n\n", printable(results.speeds.back().command));
}

std::string dense(const Results& results) {
  if (results.dense.empty()) return {};
  std::string text =
      "## The clocked engine and a plain dense loop\n\nThe same Program of Pixel-planes; the loop is "
      "`tests/performance/dense_loop.cpp`.\n\n"
      "| model | clocks | clocked ms | dense loop ms | clocked / dense |\n|---|--:|--:|--:|--:|\n";
  for (const DensePair& row : results.dense) {
    text += fmt::format("| {} | {} | {} | {} | {} |\n", printable(row.model), row.clocks, milliseconds(row.clocked),
                        milliseconds(row.dense), short_number(row.ratio()));
  }
  return text + fmt::format("\nThe last by `{}` and the loop in turn, the others likewise.\n\n",
                            printable(results.dense.back().command));
}

std::string rivals(const Results& results) {
  if (results.rivals.empty()) return {};
  std::string text =
      "## Whole processes\n\nFrom start to end, a PNG of 512 x 512 pixels each, in turn.\n\n"
      "| model | command | ms | csgsim ms | csgsim / other |\n|---|---|--:|--:|--:|\n";
  for (const Rival& row : results.rivals) {
    if (!row.reason.empty()) {
      text += fmt::format("| {} | `{}` | {} | – | – |\n", printable(row.model), printable(row.command),
                          printable(row.reason));
      continue;
    }
    text += fmt::format("| {} | `{}` | {} | {} | {} |\n", printable(row.model), printable(row.command),
                        milliseconds(row.rival), milliseconds(row.csgsim), short_number(row.ratio()));
  }
  return text + fmt::format("\ncsgsim by `{}`, and likewise.\n\n", printable(results.rivals.back().csgsim_command));
}

std::string growths(const Results& results) {
  if (results.growths.empty()) return {};
  std::string text =
      "## Growth\n\nSeconds as a power of what grows, fitted to three points or more, all else being equal; "
      "Pixel-planes, "
      "functional "
      "level. 1: in proportion; of threads, -1 would be perfect.\n\n"
      "| against | part | exponent | ms at each size |\n|---|---|--:|---|\n";
  for (const Growth& row : results.growths) {
    std::string points;
    for (const Point& point : row.points)
      points += fmt::format("{}{:g}: {}", points.empty() ? "" : ", ", point.x, milliseconds(point.y));
    const std::optional<double> power = row.power();
    text += fmt::format("| {} | {} | {} | {} |\n", row.against, row.part, power ? fmt::format("{:.2f}", *power) : "–",
                        points);
  }
  text += "\nThe largest by:\n\n";
  for (const Growth& row : results.growths) text += fmt::format("    {}\n", printable(row.command));
  return text + "\n";
}

}  // namespace

std::string to_tables(const Results& results) {
  const Build& build = results.build;
  return fmt::format("{}, {} cores, {}; {}, `{}`{}{}. Medians of up to {} rounds.\n\n", build.cpu, build.cores,
                     build.vectors, build.compiler, build.flags, build.commit.empty() ? "" : "; commit ", build.commit,
                     results.settings.rounds.most) +
         speeds(results) + dense(results) + rivals(results) + growths(results);
}

}  // namespace csgsim::bench
