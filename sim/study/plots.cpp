#include "sim/study/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/study/gnuplot.h"
#include "sim/study/pareto.h"

namespace csgsim::study {

namespace {

/// What a knob's plot shows against clocks.
struct Axis {
  const char* knob;
  const char* title;
  const char* error;                  ///< left axis
  std::uint64_t Measurement::*wrong;  ///< left axis: pixels
  double Measurement::*depth;         ///< right axis: model units
  bool wide;                          ///< clocks range over more than a decade
};

constexpr Axis axes[] = {
    {"z-bits", "bits of depth", "wrong pixels", &Measurement::wrong, &Measurement::depth_p999, false},
    {"fraction-bits", "fraction bits of the coefficients", "wrong pixels", &Measurement::wrong,
     &Measurement::depth_p999, false},
    {"edge-on", "edge-on fraction", "wrong pixels", &Measurement::wrong, &Measurement::depth_p999, false},
    {"size", "picture size", "wrong pixels", &Measurement::wrong, &Measurement::depth_p999, false},
    {"fn", "fragments of a circle, $fn", "pixels that differ from the curved surfaces", &Measurement::facet_wrong,
     &Measurement::facet_depth_p999, true},
    {"tolerance", "faceting tolerance, model units", "pixels that differ from the curved surfaces",
     &Measurement::facet_wrong, &Measurement::facet_depth_p999, true},
};

/// The range of an axis that shows values from least to most: gnuplot wants more than one value.
std::string range_command(const char* axis, double least, double most) {
  return least < most ? std::string() : fmt::format("set {}range [{}:{}]\n", axis, least / 2.0, most * 2.0);
}

std::string knob_script(const Axis& axis, std::span<const Measurement> rows, const std::string& model) {
  std::string data;
  std::vector<double> wrong;
  std::vector<double> depth;
  for (const Measurement& row : rows) {
    if (row.knob != axis.knob) continue;
    // Where nothing is wrong a logarithmic axis needs something to show.
    wrong.push_back(static_cast<double>(row.*axis.wrong) + 0.5);
    depth.push_back(row.*axis.depth + 1e-12);
    data += fmt::format("{} {} {} {}\n", row.clocks, wrong.back(), depth.back(), data_text(row.value));
  }
  if (data.empty()) return {};
  const auto [least_wrong, most_wrong] = std::minmax_element(wrong.begin(), wrong.end());
  const auto [least_depth, most_depth] = std::minmax_element(depth.begin(), depth.end());
  const std::string ranges =
      range_command("y", *least_wrong, *most_wrong) + range_command("y2", *least_depth, *most_depth);
  return ranges + fmt::format(
                      "set title {} noenhanced\nset xlabel 'clocks'\nset ylabel '{} (+ 0.5)'\nset y2label 'depth "
                      "error, 99.9 % of "
                      "pixels, model "
                      "units'\n"
                      "set logscale {}\nset ytics nomirror\nset y2tics\nset format y2 '%.0e'\nset key outside bottom "
                      "horizontal\nset "
                      "grid xtics ytics\n"
                      "set offsets graph 0.08, graph 0.12, graph 0.08, graph 0.05\n$data << EOD\n{}EOD\n"
                      "plot $data using 1:2 with linespoints pt 7 lw 2 title '{}', $data using 1:2:4 with labels "
                      "offset 0,0.9 notitle, "
                      "$data using 1:3 axes x1y2 with linespoints pt 5 dt 2 title 'depth error (right)'\n",
                      plot_text(model + ": " + axis.title), axis.error, axis.wide ? "xyy2" : "yy2", data, axis.error);
}

std::string front_script(std::span<const Measurement> rows, const std::string& model) {
  std::vector<Measurement> together;
  for (const Measurement& row : rows) {
    if (row.knob == "together") together.push_back(row);
  }
  if (together.empty()) return {};
  std::string all;
  for (const Measurement& row : together)
    all += fmt::format("{} {} {}\n", row.clocks, static_cast<double>(row.wrong) + 0.5, data_text(row.value));
  std::string best;
  for (const Measurement& row : pareto_front(together))
    best += fmt::format("{} {} {}\n", row.clocks, static_cast<double>(row.wrong) + 0.5, data_text(row.value));
  return fmt::format(
      "set title {} noenhanced\nset xlabel 'clocks'\nset ylabel 'wrong pixels (+ 0.5)'\nset logscale y\nset key "
      "outside bottom "
      "horizontal\nset grid\n"
      "set offsets graph 0.05, graph 0.1, graph 0.1, graph 0.05\n$all << EOD\n{}EOD\n$front << EOD\n{}EOD\n"
      "plot $all using 1:2 with points pt 7 ps 0.7 lc rgb 'gray50' title 'z bits / fraction bits', "
      "$front using 1:2 with linespoints pt 7 lw 2 lc rgb 'dark-red' title 'Pareto front', $front using 1:2:3 with "
      "labels offset 3,0.7 notitle\n",
      plot_text(model + ": what accuracy costs"), all, best);
}

}  // namespace

std::vector<std::filesystem::path> draw_plots(std::span<const Measurement> rows, const std::string& model,
                                              const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  const auto draw = [&](const std::string& name, const std::string& script) {
    if (script.empty()) return;
    for (std::filesystem::path& file : draw_plot(folder, name, script)) files.push_back(std::move(file));
  };
  for (const Axis& axis : axes) draw(axis.knob, knob_script(axis, rows, model));
  draw("pareto", front_script(rows, model));
  return files;
}

}  // namespace csgsim::study
