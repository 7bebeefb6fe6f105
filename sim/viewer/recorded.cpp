#include "sim/viewer/recorded.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "hw/base/error.h"
#include "hw/isa/binary.h"
#include "sim/system/own_program.h"

namespace csgsim::viewer {

std::string record_wave(const isa::Program& program, std::span<const std::string> options) {
  return record_wave_with(system::own_program(), program, options);
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
