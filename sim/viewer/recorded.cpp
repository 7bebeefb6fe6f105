#include "sim/viewer/recorded.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "hw/base/error.h"
#include "hw/isa/binary.h"

namespace csgsim::viewer {

namespace {

/// Path of the running program.
std::string own_program() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error)
    throw InputError("csgsim: cannot find its own program file: " + error.message() + "; check that /proc is mounted");
  return program.native();
}

}  // namespace

std::string record_wave(const isa::Program& program, std::span<const std::string> options) {
  return record_wave_with(own_program(), program, options);
}

std::string record_wave_with(const std::string& csgsim_path, const isa::Program& program,
                             std::span<const std::string> options, const system::ChildLimits& limits) {
  std::vector<std::string> words{csgsim_path, "wave", "/dev/stdin"};
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), {"--output", "-"});
  const std::vector<std::byte> bytes = isa::encode(program);
  system::MemoryFile input("the Program of a wave");
  input.write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  std::optional<system::ChildEnd> end = system::run_child(words, input, limits);
  if (!end)
    throw InputError("cannot run csgsim wave: the csgsim executable has been moved or deleted; restart csgsim view");
  if (system::has_succeeded(*end)) return std::move(end->output);
  const std::string why = system::failure_text(*end, limits);
  if (end->exceeded == system::Exceeded::nothing) throw InputError(why);
  throw InputError("csgsim wave: " + why + "; use a smaller picture, or record it with csgsim wave and a --window");
}

}  // namespace csgsim::viewer
