#include "sim/study/gnuplot.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "hw/isa/error.h"

namespace csgsim::study {

namespace {

std::string output(const std::filesystem::path& file, PlotSize size) {
  const bool svg = file.extension() == ".svg";
  return fmt::format("set terminal {} size {},{} font 'sans,{}'\nset output {}\n",
                     svg ? "svg background 'white'" : "pngcairo", size.width, size.height, svg ? 14 : 11,
                     quoted(file.string()));
}

void run_gnuplot(const std::string& script) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen("gnuplot", "w"), ::pclose);
  if (!pipe || std::fputs(script.c_str(), pipe.get()) == EOF || std::fflush(pipe.get()) != 0) {
    throw InputError("gnuplot cannot be run; install it (package gnuplot-nox) or do without plots with --no-plots");
  }
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::vector<std::filesystem::path> draw_plot(const std::filesystem::path& folder, const std::string& name,
                                             const std::string& script, PlotSize size) {
  std::vector<std::filesystem::path> files;
  for (const char* ending : {".png", ".svg"}) {
    files.push_back(folder / (name + ending));
    std::filesystem::remove(files.back());  // so that what is there afterwards is new
    run_gnuplot("set encoding utf8\n" + output(files.back(), size) + script);
    if (!std::filesystem::exists(files.back())) {
      throw InputError(files.back().string() +
                       ": gnuplot did not draw it; is package gnuplot-nox installed? (--no-plots does without)");
    }
  }
  return files;
}

}  // namespace csgsim::study
