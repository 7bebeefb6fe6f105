#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <optional>
#include <string_view>

#include "hw/base/error.h"
#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "tests/performance/process.h"
#include "tests/performance/runs.h"

namespace csgsim::bench {

namespace {

constexpr const char* level = "functional";

/// The number of processor instructions in callgrind's output file, if present.
std::optional<std::uint64_t> summary_of(const std::filesystem::path& calls) {
  std::ifstream file(calls);
  for (std::string line; std::getline(file, line);) {
    for (const std::string_view key : {"summary: ", "totals: "}) {
      if (!line.starts_with(key)) continue;
      std::uint64_t count = 0;
      const auto [end, error] = std::from_chars(line.data() + key.size(), line.data() + line.size(), count);
      if (error == std::errc{}) return count;
    }
  }
  return std::nullopt;
}

/// Reason why the processor's instructions are unknown.
struct NotCounted {
  std::string reason;
};

/// The processor's instructions for the whole process.
std::uint64_t instructions_of(const Settings& settings, const Words& words) {
  const std::filesystem::path calls = settings.folder / "calls.out";
  Words counting{"valgrind", "--tool=callgrind", "--callgrind-out-file=" + calls.native()};
  counting.insert(counting.end(), words.begin(), words.end());
  try {
    if (!run_process(counting)) throw NotCounted{"valgrind: not installed"};
  } catch (const InputError& error) {
    throw NotCounted{error.what()};
  }
  const std::optional<std::uint64_t> count = summary_of(calls);
  if (!count) throw NotCounted{"valgrind: printed no sum"};
  return *count;
}

void count_instructions(const Settings& settings, const std::filesystem::path& model, Count& count) {
  try {
    for (const Settings& side : build_settings(settings)) {
      const Compiled compiled = compile(side, model, count.machine, side.size);
      const std::uint64_t instructions = instructions_of(side, run_words(side, compiled, level));
      if (side.csgsim == settings.csgsim) {
        count.instructions = instructions;
      } else {
        count.others = instructions;
      }
    }
  } catch (const NotCounted& why) {
    count.reason = why.reason;
  }
}

Count count_of(const Settings& settings, const std::filesystem::path& model, const std::string& machine) {
  const Compiled compiled = compile(settings, model, machine, settings.size);
  const isa::Program program = isa::load_program(compiled.program);
  Count count{model.stem().native(), machine, work_of(program, replay(program, kinds::load(program.machine)))};
  count.command = command_text(Words{"csgsim_bench", "count", compiled.program.native()});
  count_instructions(settings, model, count);
  return count;
}

}  // namespace

std::vector<Count> measure_counts(const Settings& settings) {
  std::vector<Count> all;
  for (const std::filesystem::path& model : all_models(settings)) {
    for (const std::string& machine : settings.machines) all.push_back(count_of(settings, model, machine));
  }
  return all;
}

}  // namespace csgsim::bench
