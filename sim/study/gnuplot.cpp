#include "sim/study/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "hw/base/child_process.h"
#include "hw/base/error.h"
#include "hw/base/memory_file.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "sim/study/hash.h"

namespace csgsim::study {

namespace {

std::string terminal(std::string_view ending, PlotSize size) {
  const bool svg = ending == ".svg";
  return fmt::format("set terminal {} size {},{} font 'sans,{}'\nset output\n",
                     svg ? "svg background 'white'" : "pngcairo", size.width, size.height, svg ? 14 : 11);
}

/// What gnuplot draws for the file when it reads the script and nothing else, not even its user's settings.
std::string drawn_by(const std::filesystem::path& file, const std::string& script) {
  MemoryFile input(file);
  const MemoryFile output(file);
  const MemoryFile errors(file);
  input.write(script);
  const std::array<std::string, 2> words{"gnuplot", "-d"};
  const std::optional<int> status = run_child(words, {input, output, errors});
  if (!status)
    throw InputError(file.native() +
                     ": gnuplot cannot be run; install it (package gnuplot-nox) or do without plots with --no-plots");
  std::string picture = output.content();
  if (*status != 0 || picture.empty()) {
    throw InputError(
        fmt::format("{}: gnuplot did not draw ({}); is package gnuplot-nox installed? (--no-plots does without)",
                    file.native(), why_failed(*status, errors)));
  }
  return picture;
}

bool is_plain(char byte) {
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') ||
         std::string_view(" .,:;/()_+-<>=").find(byte) != std::string_view::npos;
}

}  // namespace

std::string plot_text(std::string_view bytes) {
  std::string result = "\"";
  for (const char byte : printable(bytes))
    result += is_plain(byte) ? std::string(1, byte) : fmt::format("\\{:03o}", static_cast<unsigned char>(byte));
  return result + "\"";
}

std::string tick_text(std::string_view bytes) {
  std::string doubled;
  for (const char byte : bytes) doubled += byte == '%' ? std::string("%%") : std::string(1, byte);
  return plot_text(doubled);
}

std::string data_text(std::string_view bytes) {
  std::string result = "\"";
  for (const char byte : printable(bytes))
    if (byte != '"' && byte != '\\') result += byte;
  return result + "\"";
}

std::string plot_stem(const std::filesystem::path& model) {
  constexpr std::size_t longest = 100;
  std::string stem = model.stem().native();
  if (stem.size() <= longest) return stem;
  Hash hash;
  hash.add(stem);
  return stem.substr(0, longest) + "-" + hash.text();
}

std::vector<std::filesystem::path> draw_plot(const std::filesystem::path& folder, const std::string& name,
                                             const std::string& script, PlotSize size) {
  std::vector<std::filesystem::path> files;
  for (const char* ending : {".png", ".svg"}) {
    files.push_back(folder / (name + ending));
    write_file(files.back(), drawn_by(files.back(), "set encoding utf8\n" + terminal(ending, size) + script));
  }
  return files;
}

}  // namespace csgsim::study
