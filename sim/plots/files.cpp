#include "sim/plots/files.h"

#include "hw/base/output_file.h"
#include "sim/plots/gnuplot.h"
#include "sim/plots/layout.h"
#include "sim/plots/svg.h"

namespace csgsim::plots {

std::vector<std::filesystem::path> write_plots(std::span<const Plot> plots, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const Plot& plot : plots) {
    const Drawing drawing = lay_out(plot);
    const std::filesystem::path png = folder / (plot.name + ".png");
    const std::filesystem::path svg = folder / (plot.name + ".svg");
    write_file(png, draw_png(png, drawing).picture);
    write_file(svg, svg_file(drawing));
    files.insert(files.end(), {png, svg});
  }
  return files;
}

}  // namespace csgsim::plots
