#include "sim/plots/gnuplot.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/plots/glyphs.h"
#include "sim/plots/program_limits.h"
#include "sim/plots/text_size.h"
#include "sim/system/child_process.h"
#include "sim/system/memory_file.h"

namespace csgsim::plots {

namespace {

constexpr double points_per_pixel = 72.0 / 96.0;  ///< font size in points per pixel, as cairo defines it
constexpr double mark_units = 10.5;               ///< diameter in pixels of gnuplot's marks of size 1

/// Whether the picture has the end marker of a PNG file.
bool is_whole(std::string_view picture) { return picture.ends_with(std::string_view("IEND\xae\x42\x60\x82", 8)); }

bool is_plain(char byte) {
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') ||
         std::string_view(" .,:;/()_+-<>=").find(byte) != std::string_view::npos;
}

std::string_view name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::left: return "left";
    case Anchor::centre: return "center";
    case Anchor::right: return "right";
  }
  return "";
}

/// Data block of lines or marks with one style. gnuplot draws the blocks in the order of the script.
struct Curve {
  std::string data;
  std::string style;
};

std::vector<Curve> curves_of(const Drawing& drawing) {
  std::vector<Curve> curves;
  const auto add = [&](const std::string& data, const std::string& style) {
    if (curves.empty() || curves.back().style != style) curves.push_back({"", style});
    curves.back().data += data + "\n";  // an empty line ends a line
  };
  for (const Line& line : drawing.lines) {
    std::string data;
    for (const Pixel& point : line.points)
      fmt::format_to(std::back_inserter(data), "{:.2f} {:.2f}\n", point.x, point.y);
    add(data, fmt::format("lines lc rgb '{}' lw {}{}", line.colour, line.width,
                          line.dash.empty() ? " dt solid" : fmt::format(" dt ({})", line.dash)));
  }
  for (const Mark& mark : drawing.marks) {
    add(fmt::format("{:.2f} {:.2f}\n", mark.at.x, mark.at.y),
        fmt::format("points lc rgb '{}' lw 2 pt {} ps {:.2f}", mark.colour, static_cast<unsigned>(mark.form),
                    mark.size / mark_units));
  }
  return curves;
}

/// Extracts gnuplot's error message: the first line with a line number. The lines before it repeat the script.
std::string message_of(const std::string& messages) {
  constexpr std::string_view before = "line ";
  constexpr std::size_t longest = 200;
  for (std::size_t begin = 0; begin < messages.size();) {
    const std::size_t end = std::min(messages.find('\n', begin), messages.size());
    const std::string line = messages.substr(begin, end - begin);
    const std::size_t colon = line.find(": ");
    if (line.starts_with(before) && colon != std::string::npos) return printable(line.substr(colon + 2, longest));
    begin = end + 1;
  }
  return "";
}

std::string failure_reason(const system::ChildEnd& end) {
  if (end.exceeded != system::Exceeded::nothing || WIFSIGNALED(end.status))
    return system::failure_text(end, program_limits);
  const std::string message = message_of(end.errors);
  if (!message.empty()) return "gnuplot reports: " + message;
  return end.status == 0 ? "the picture is incomplete"
                         : fmt::format("gnuplot exited with status {}", WEXITSTATUS(end.status));
}

/// Replaces characters that no font on this computer has.
Drawing without_missing_glyphs(Drawing drawing) {
  for (Text& text : drawing.texts) text.text = replace_missing_glyphs(text.text);
  return drawing;
}

}  // namespace

std::string gnuplot_text(std::string_view bytes) {
  std::string result = "\"";
  for (const char byte : printable(bytes))
    result += is_plain(byte) ? std::string(1, byte) : fmt::format("\\{:03o}", static_cast<unsigned char>(byte));
  return result + "\"";
}

std::string gnuplot_script(const Drawing& drawing) {
  std::string script = fmt::format(
      "set lmargin at screen 0\nset rmargin at screen 1\nset tmargin at screen 1\nset bmargin at screen 0\n"
      "unset border\nunset tics\nunset key\nset xrange [0:{}]\nset yrange [{}:0]\n",
      drawing.width, drawing.height);
  const auto add = [&]<class... Values>(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(script), format, std::forward<Values>(values)...);
  };
  for (const Fill& fill : drawing.fills) {
    const Box& box = fill.box;
    add("set object rectangle from {:.2f},{:.2f} to {:.2f},{:.2f} fc rgb '{}' fs solid 1 border lc rgb 'black' back\n",
        box.left, box.top, box.right, box.bottom, fill.colour);
  }
  for (const Text& text : drawing.texts) {
    add("set label {} at {:.2f},{:.2f} {}{} front noenhanced tc rgb '{}'\n", gnuplot_text(text.text), text.at.x,
        text.at.y, name_of(text.anchor), text.is_upright ? " rotate by 90" : "", text.colour);
  }
  const std::vector<Curve> curves = curves_of(drawing);
  for (std::size_t i = 0; i < curves.size(); ++i) add("$c{} << EOD\n{}EOD\n", i, curves[i].data);
  for (std::size_t i = 0; i < curves.size(); ++i)
    add("{}$c{} using 1:2 with {}", i == 0 ? "plot " : ", ", i, curves[i].style);
  return script + "\n";
}

PngResult draw_png(const std::filesystem::path& file, const Drawing& drawing) {
  system::MemoryFile input(file);
  input.write(fmt::format("set encoding utf8\nset terminal pngcairo size {:.0f},{:.0f} font 'sans,{}'\nset output\n{}",
                          drawing.width, drawing.height, font_size * points_per_pixel,
                          gnuplot_script(without_missing_glyphs(drawing))));
  const std::array<std::string, 2> words{"gnuplot", "-d"};  // -d ignores the user's gnuplot settings
  std::optional<system::ChildEnd> ended = system::run_child(words, input, program_limits);
  if (!ended)
    throw InputError(file.native() +
                     ": gnuplot cannot be run; install it (package gnuplot-nox) or omit the plots with --no-plots");
  if (!system::has_succeeded(*ended) || !is_whole(ended->output)) {
    throw InputError(
        fmt::format("{}: gnuplot drew no picture; {} (package gnuplot-nox can draw it; --no-plots omits plots)",
                    file.native(), failure_reason(*ended)));
  }
  return {std::move(ended->output), std::move(ended->errors)};
}

}  // namespace csgsim::plots
