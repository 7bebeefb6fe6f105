#include "sim/study/sweep_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "sim/study/gnuplot.h"
#include "sim/study/memory_plot.h"

namespace csgsim::study {

namespace {

using Value = std::function<std::uint64_t(const SweepRow&)>;

/// What is plotted: bits to the right, counts upwards.
struct Curve {
  std::string what;  ///< of the series; may be empty
  Value bits;
  Value count;
};

struct Mark {
  std::uint64_t bits = 0;
  std::uint64_t count = 0;
  unsigned stack_bits = 0;

  bool operator==(const Mark&) const = default;
};

/// One strategy under the same conditions, and under others that give the same marks.
struct Line {
  std::size_t strategy = 0;  ///< says the colour
  std::size_t group = 0;     ///< says the mark's shape
  std::size_t curve = 0;     ///< says the dashes
  std::string title;
  std::vector<Mark> marks;
  unsigned alike = 0;  ///< lines that would cover this one
};

std::vector<Line> lines_of(std::span<const SweepRow> rows, const std::vector<Curve>& curves) {
  const PointNames names(rows);
  std::vector<std::string> strategies;
  std::vector<Line> lines;
  std::size_t group = 0;
  const auto add = [&](Line line) {
    const auto same = std::find_if(lines.begin(), lines.end(), [&](const Line& one) {
      return one.strategy == line.strategy && one.curve == line.curve && one.marks == line.marks;
    });
    same == lines.end() ? lines.push_back(std::move(line)) : void(++same->alike);
  };
  for (const std::vector<SweepRow>& of_group : by_conditions(rows)) {
    std::map<std::pair<std::size_t, std::size_t>, Line> found;
    for (const SweepRow& row : of_group) {
      if (!row.compiled()) continue;
      const std::string& strategy = row.point.strategy;
      if (std::find(strategies.begin(), strategies.end(), strategy) == strategies.end()) strategies.push_back(strategy);
      const auto index =
          static_cast<std::size_t>(std::find(strategies.begin(), strategies.end(), strategy) - strategies.begin());
      const std::string conditions = names.conditions(row.point);
      for (std::size_t c = 0; c < curves.size(); ++c) {
        Line& line = found[{index, c}];
        line.strategy = index;
        line.group = group;
        line.curve = c;
        line.title = strategy + (curves[c].what.empty() ? "" : " " + curves[c].what) +
                     (conditions.empty() ? "" : ", " + conditions);
        line.marks.push_back({curves[c].bits(row), curves[c].count(row), row.point.stack_bits});
      }
    }
    for (auto& [key, line] : found) add(std::move(line));
    ++group;
  }
  return lines;
}

std::string title_of(const Line& line) {
  return line.alike == 0 ? line.title : fmt::format("{} (+ {} alike)", line.title, line.alike);
}

/// With room for the key at the right.
PlotSize size_with_key(const std::vector<Line>& lines) {
  std::size_t longest = 0;
  for (const Line& line : lines) longest = std::max(longest, title_of(line).size());
  return {760 + character_width * static_cast<unsigned>(longest),
          std::max(480U, 80 + line_height * static_cast<unsigned>(lines.size()))};
}

/// Ranges that hold all marks; over more than a decade, or so, counts are better on a logarithmic axis.
std::string ranges_script(const std::vector<Line>& lines, bool from_zero) {
  Mark low = lines.front().marks.front();
  Mark high = low;
  for (const Line& line : lines) {
    for (const Mark& mark : line.marks) {
      low = {std::min(low.bits, mark.bits), std::min(low.count, mark.count), 0};
      high = {std::max(high.bits, mark.bits), std::max(high.count, mark.count), 0};
    }
  }
  const auto least = static_cast<double>(low.count);
  const auto most = static_cast<double>(high.count);
  const std::string x =
      fmt::format("set xrange [{}:{}]\n", static_cast<double>(low.bits) - 0.5, static_cast<double>(high.bits) + 0.8);
  if (least > 0 && most / least >= 20)
    return x + fmt::format("set logscale y\nset yrange [{}:{}]\n", least / 1.2, most * 1.2);
  const double room = std::max(1.0, (from_zero ? most : most - least) * 0.1);
  return x + fmt::format("set yrange [{}:{}]\n", from_zero ? 0.0 : least - room, most + room);
}

/// The stack bits that the marks of strategy bits were given: those at the same place share a label.
/// Many lines would cover each other's.
std::string labels_script(const std::vector<Line>& lines) {
  constexpr std::ptrdiff_t most_labelled = 2;
  const auto is_given = [](const Line& line) { return line.marks.front().stack_bits > 0; };
  if (std::count_if(lines.begin(), lines.end(), is_given) > most_labelled) return {};
  std::string script;
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.marks.size();) {
      const Mark& first = line.marks[i];
      std::size_t end = i + 1;
      while (end < line.marks.size() && line.marks[end].bits == first.bits && line.marks[end].count == first.count)
        ++end;
      const std::string last = end > i + 1 ? fmt::format("..{}", line.marks[end - 1].stack_bits) : "";
      if (first.stack_bits > 0)
        script += fmt::format("set label 'm = {}{}' at {},{} left offset 0.8,0.5 front\n", first.stack_bits, last,
                              first.bits, first.count);
      i = end;
    }
  }
  return script;
}

std::string lines_script(const std::vector<Line>& lines) {
  constexpr unsigned shapes[] = {7, 5, 9, 11, 13};
  std::string data;
  std::string plots;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    data += fmt::format("$line{} << EOD\n", i);
    for (const Mark& mark : line.marks) data += fmt::format("{} {}\n", mark.bits, mark.count);
    data += "EOD\n";
    plots += fmt::format(
        "{} $line{} using 1:2 with linespoints lw 2 lc {} pt {} ps {} dt {} title {} noenhanced", i == 0 ? "plot" : ",",
        i, line.strategy + 1, shapes[line.group % std::size(shapes)] - line.curve,
        std::max(0.8, 2.0 - 0.4 * static_cast<double>(line.strategy)), line.curve + 1, plot_text(title_of(line)));
  }
  return data + plots + "\n";
}

std::string axes_script(const std::string& title, const char* x, const char* y) {
  return fmt::format(
      "set title {} noenhanced\nset xlabel {}\nset ylabel {}\nset xtics 1\nset grid\nset key outside right top\n",
      plot_text(title), plot_text(x), plot_text(y));
}

std::vector<Line> scan_lines(std::span<const SweepRow> rows) {
  // What other strategies use stands beside what strategy bits is given.
  const Value bits = [](const SweepRow& row) {
    return row.point.stack_bits > 0 ? row.point.stack_bits : row.classification_bits;
  };
  return lines_of(rows, {{"rendered", bits, [](const SweepRow& row) { return row.rendered; }},
                         {"classified", bits, [](const SweepRow& row) { return row.classified; }}});
}

std::string scan_script(const std::vector<Line>& lines, const std::string& model) {
  return axes_script(model + ": scan-conversions of primitives",
                     "bits for the classification: given (bits), used (others)", "scan-conversions") +
         ranges_script(lines, true) + lines_script(lines);
}

std::vector<Line> clock_lines(std::span<const SweepRow> rows) {
  return lines_of(rows, {{"", [](const SweepRow& row) { return row.classification_bits; },
                          [](const SweepRow& row) { return row.clocks; }}});
}

std::string clocks_script(const std::vector<Line>& lines, const std::string& model) {
  return axes_script(model + ": what memory buys", "bits of pixel memory that the classification uses", "clocks") +
         "set format y '%.1s %c'\n" + ranges_script(lines, false) + labels_script(lines) + lines_script(lines);
}

}  // namespace

std::vector<std::filesystem::path> draw_sweep(std::span<const SweepRow> rows, const std::string& model,
                                              const std::filesystem::path& folder) {
  const std::vector<Line> scans = scan_lines(rows);
  if (scans.empty()) return {};
  const std::vector<Line> clocks = clock_lines(rows);
  std::vector<std::filesystem::path> files;
  const auto add = [&](const std::vector<std::filesystem::path>& drawn) {
    files.insert(files.end(), drawn.begin(), drawn.end());
  };
  add(draw_plot(folder, model + "_scan_conversions", scan_script(scans, model), size_with_key(scans)));
  add(draw_plot(folder, model + "_clocks", clocks_script(clocks, model), size_with_key(clocks)));
  add(draw_memory(rows, model, folder));
  return files;
}

}  // namespace csgsim::study
