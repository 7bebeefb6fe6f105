#include "sim/study/gnuplot.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

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

/// What the child's standard files are connected to.
class Actions {
 public:
  Actions() { ::posix_spawn_file_actions_init(&actions_); }
  ~Actions() { ::posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  void connect(const MemoryFile& file, int number) {
    ::posix_spawn_file_actions_adddup2(&actions_, file.descriptor().number(), number);
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// The first line of what gnuplot says.
std::string complaint(const MemoryFile& errors) {
  const std::string all = errors.content();
  const std::size_t begin = std::min(all.find_first_not_of(" \n"), all.size());
  return all.substr(begin, all.find('\n', begin) - begin);
}

/// What gnuplot draws for the file when it reads the script and nothing else, not even its user's settings.
std::string drawn_by(const std::filesystem::path& file, const std::string& script) {
  MemoryFile input(file);
  const MemoryFile output(file);
  const MemoryFile errors(file);
  input.write(script);
  Actions actions;
  actions.connect(input, STDIN_FILENO);
  actions.connect(output, STDOUT_FILENO);
  actions.connect(errors, STDERR_FILENO);
  std::array<char, 8> name{"gnuplot"};
  std::array<char, 3> no_settings{"-d"};
  const std::array<char*, 3> arguments{name.data(), no_settings.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, name.data(), actions.get(), nullptr, arguments.data(), environ) != 0)
    throw InputError(file.native() +
                     ": gnuplot cannot be run; install it (package gnuplot-nox) or do without plots with --no-plots");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  std::string picture = output.content();
  if (status != 0 || picture.empty()) {
    throw InputError(
        fmt::format("{}: gnuplot did not draw ({}); is package gnuplot-nox installed? (--no-plots does without)",
                    file.native(), WIFSIGNALED(status) ? ::strsignal(WTERMSIG(status)) : complaint(errors)));
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
