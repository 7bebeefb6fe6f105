#include <fmt/format.h>

#include <algorithm>

#include "sim/bench/report.h"
#include "sim/study/gnuplot.h"

namespace csgsim::bench {

namespace {

/// The lines of one plot: all parts that are measured against the same.
std::string script_of(const std::vector<Growth>& growths, const std::string& against) {
  std::string data;
  std::string plots;
  for (const Growth& growth : growths) {
    if (growth.against != against) continue;
    data += fmt::format("${} << EOD\n", growth.part);
    for (const Point& point : growth.points) data += fmt::format("{} {}\n", point.x, point.y * 1e3);
    data += "EOD\n";
    plots += fmt::format("{}${} using 1:2 with linespoints pt 7 lw 2 title '{}: exponent {:.2f}'",
                         plots.empty() ? "plot " : ", ", growth.part, growth.part, growth.power());
  }
  return fmt::format(
      "set title 'csgsim against {0}'\nset xlabel '{0}'\nset ylabel 'ms'\nset logscale xy\nset grid\n"
      "set key outside bottom horizontal\nset offsets graph 0.05, graph 0.05, graph 0.1, graph 0.1\n{1}{2}\n",
      against, data, plots);
}

}  // namespace

std::vector<std::filesystem::path> draw_growths(const Results& results) {
  std::vector<std::string> drawn;
  std::vector<std::filesystem::path> files;
  for (const Growth& growth : results.growths) {
    if (std::ranges::find(drawn, growth.against) != drawn.end()) continue;
    drawn.push_back(growth.against);
    for (std::filesystem::path& file : study::draw_plot(results.settings.folder, "growth_" + growth.against,
                                                        script_of(results.growths, growth.against)))
      files.push_back(std::move(file));
  }
  return files;
}

}  // namespace csgsim::bench
