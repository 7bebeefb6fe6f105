#include <fmt/format.h>

#include <optional>

#include "hw/base/text.h"
#include "tests/performance/report.h"

namespace csgsim::bench {

namespace {

/// The value with three significant digits.
std::string short_number(double value) { return fmt::format("{:.3g}", value); }

/// Time and ratio of the other build; empty if there is none.
template <class Text>
std::string other_cells(const Compared& compared, Text text) {
  if (!compared.other) return {};
  return fmt::format(" {} | {} |", text(compared.other->seconds), short_number(compared.other->ratio));
}

std::string milliseconds(double seconds) { return fmt::format("{:.4g}", seconds * 1e3); }

std::string speeds(const Results& results) {
  if (results.speeds.empty()) return {};
  const bool beside = results.speeds.front().wall.other.has_value();
  std::string text = fmt::format(
      "## Runs\n\nRun time of the simulation alone, without process start, input and output: the first run of a "
      "process, {} pixels. The pictures show the whole model (`--view-all`), so clocks differ from those of other "
      "pages.\n\n"
      "| model | machine | level | clocks | simulated ms | wall ms | simulated s / wall s |{}\n"
      "|---|---|---|--:|--:|--:|--:|{}\n",
      results.settings.size, beside ? " other ms | other ÷ this |" : "", beside ? "--:|--:|" : "");
  for (const Speed& row : results.speeds) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |{}\n", printable(row.model), printable(row.machine),
                        row.level, row.clocks, milliseconds(row.simulated), milliseconds(row.wall.seconds),
                        short_number(row.ratio()), other_cells(row.wall, milliseconds));
  }
  return text + fmt::format("\nCommand of the last row: `{}`.\n\n", printable(results.speeds.back().command));
}

std::string dense(const Results& results) {
  if (results.dense.empty()) return {};
  std::string text =
      "## The cycle level and a plain dense loop\n\nThe same Program of Pixel-planes; the source of the loop is "
      "`tests/performance/dense_loop.cpp`.\n\n"
      "| model | clocks | clocked ms | dense loop ms | clocked / dense |\n|---|--:|--:|--:|--:|\n";
  for (const DensePair& row : results.dense) {
    text += fmt::format("| {} | {} | {} | {} | {} |\n", printable(row.model), row.clocks, milliseconds(row.clocked),
                        milliseconds(row.dense), short_number(row.ratio()));
  }
  return text + fmt::format("\nCommand of the last row: `{}`, alternating with the loop.\n\n",
                            printable(results.dense.back().command));
}

std::string rivals(const Results& results) {
  if (results.rivals.empty()) return {};
  std::string text =
      "## Whole processes\n\nRun time of whole processes that write a PNG of 512 x 512 pixels, measured "
      "alternately.\n\n"
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
  return text +
         fmt::format("\nCommand of csgsim in the last row: `{}`.\n\n", printable(results.rivals.back().csgsim_command));
}

std::string points_json_text(const std::vector<Point>& points) {
  std::string text;
  for (const Point& point : points)
    text += fmt::format("{}{:g}: {}", text.empty() ? "" : ", ", point.x, milliseconds(point.y));
  return text;
}

std::string power_text(const std::vector<Point>& points) {
  const std::optional<double> power = exponent(points);
  return power ? fmt::format("{:.2f}", *power) : "–";
}

std::string growths(const Results& results) {
  if (results.growths.empty()) return {};
  const bool beside = !results.growths.front().others.empty();
  std::string text = fmt::format(
      "## Growth\n\nRun time as a power of one quantity, fitted to at least three points with all other quantities "
      "fixed; "
      "Pixel-planes, functional level. An exponent of 1 is linear; for threads, -1 is ideal. Depth is the number of "
      "levels of the tree.\n\n"
      "| against | part | exponent | ms at each size |{}\n|---|---|--:|---|{}\n",
      beside ? " other's exponent | other's ms |" : "", beside ? "--:|---|" : "");
  for (const Growth& row : results.growths) {
    text += fmt::format("| {} | {} | {} | {} |", row.against, row.part, power_text(row.points),
                        points_json_text(row.points));
    if (beside) text += fmt::format(" {} | {} |", power_text(row.others), points_json_text(row.others));
    text += "\n";
  }
  text += "\nCommands of the largest sizes:\n\n";
  for (const Growth& row : results.growths) text += fmt::format("    {}\n", printable(row.command));
  return text + "\n";
}

std::string counts(const Results& results) {
  if (results.counts.empty()) return {};
  const bool beside = !results.settings.beside.empty();
  std::string text = fmt::format(
      "## Counts\n\nWork of a run at the functional level, independent of the computer. A *tile* has at most 64 × 64 "
      "pixels; *stretches* are sequences of instructions between which threads synchronize; *instructions* are counted "
      "at each tile that executes them, and *linear* ones have a linear expression; *words* of 64 pixels' bits were "
      "processed individually; *lanes* are pixels whose number was computed or moved. *Processor* is millions of "
      "processor instructions of the whole process, by callgrind.\n\n"
      "| model | machine | tiles | stretches | instructions | linear | words | lanes | processor |{}\n"
      "|---|---|--:|--:|--:|--:|--:|--:|--:|{}\n",
      beside ? " other's | other ÷ this |" : "", beside ? "--:|--:|" : "");
  for (const Count& row : results.counts) {
    const ProgramWork& work = row.work;
    const auto millions = [](std::uint64_t count) { return fmt::format("{:.1f}", static_cast<double>(count) * 1e-6); };
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |", printable(row.model), printable(row.machine),
                        work.tiles, work.stretches, work.work.instructions, work.linear, work.work.words,
                        work.work.lanes, row.reason.empty() ? millions(row.instructions) : printable(row.reason));
    if (row.others) {
      text += fmt::format(" {} | {} |", millions(*row.others),
                          short_number(static_cast<double>(*row.others) / static_cast<double>(row.instructions)));
    }
    text += "\n";
  }
  return text + fmt::format("\nCommand of the last row: `{}`; the run under `valgrind --tool=callgrind`.\n\n",
                            printable(results.counts.back().command));
}

std::string schedules(const Results& results) {
  if (results.schedules.empty()) return {};
  std::string text =
      "## Estimated scaling with threads\n\nMilliseconds of a run at the functional level by number of threads, "
      "calculated "
      "from the time of each tile on one thread: the next tile, or segment, is assigned to the first idle thread. "
      "*Tiles*: threads synchronize at each test of the global OR; *segments*: each thread draws whole regions of the "
      "picture. The work outside tiles (*rest*) is not parallel.\n\n| model | machine | rest | measured on 2 | by |";
  for (const Point& point : results.schedules.front().tiles) text += fmt::format(" {:g} |", point.x);
  text += "\n|---|---|--:|--:|---|";
  for (std::size_t i = 0; i < results.schedules.front().tiles.size(); ++i) text += "--:|";
  text += "\n";
  for (const Schedule& row : results.schedules) {
    for (const bool whole : {false, true}) {
      text += fmt::format("| {} | {} | {} | {} | {} |", printable(row.model), printable(row.machine),
                          milliseconds(row.rest), milliseconds(row.measured_two), whole ? "segments" : "tiles");
      for (const Point& point : whole ? row.segments : row.tiles) text += fmt::format(" {} |", milliseconds(point.y));
      text += "\n";
    }
  }
  return text + "\n";
}

std::string works(const Results& results) {
  if (results.works.empty()) return {};
  const bool beside = results.works.front().wall.other.has_value();
  std::string text = fmt::format(
      "## Whole commands\n\nRun time from start to end, the peak memory of the largest process, and its bytes per "
      "half-space."
      "\n\n| name | what | s | MiB | bytes per half-space |{}\n|---|---|--:|--:|--:|{}\n",
      beside ? " other s | other ÷ this | other MiB |" : "", beside ? "--:|--:|--:|" : "");
  const auto mebibytes = [](double bytes) { return fmt::format("{:.0f}", bytes / (1024 * 1024)); };
  for (const Whole& row : results.works) {
    text += fmt::format("| `{}` | {} | {} | {} | {} |{}", row.name, row.what, short_number(row.wall.seconds),
                        mebibytes(row.memory),
                        row.halfspaces == 0 ? "–" : fmt::format("{:.0f}", row.memory / row.halfspaces),
                        other_cells(row.wall, short_number));
    if (beside) text += fmt::format(" {} |", mebibytes(row.other_memory));
    text += "\n";
  }
  text += "\nCommands:\n\n";
  for (const Whole& row : results.works)
    for (const std::string& command : row.commands) text += fmt::format("    {}\n", printable(command));
  return text + "\n";
}

}  // namespace

std::string to_tables(const Results& results) {
  const Build& build = results.build;
  const std::string beside = results.other.empty() ? "" : fmt::format("; the *other* is {}", results.other);
  return fmt::format("{}, {} cores, {}; {}, `{}`{}{}{}. Medians of up to {} rounds.\n\n", build.cpu, build.cores,
                     build.vectors, build.compiler, build.flags, build.commit.empty() ? "" : "; commit ", build.commit,
                     beside, results.settings.rounds.most) +
         speeds(results) + dense(results) + rivals(results) + growths(results) + counts(results) + schedules(results) +
         works(results);
}

}  // namespace csgsim::bench
