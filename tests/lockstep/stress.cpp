// lockstep_stress KIND FIRST LAST PROGRAMS: machines of a kind with parameters generated from the seeds FIRST to LAST,
// each at its bounds or between, draw PROGRAMS random Programs or models. There must be no deadlock, wrong bit, or
// difference between counted and predicted clocks. Each machine has a separate process, as SystemC elaborates once. A
// seed with inconsistent parameters, or whose machine rejects every Program, is skipped.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "hw/base/error.h"
#include "hw/kinds/rows.h"
#include "hw/machines/regions.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/timing.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/random_machine.h"
#include "tests/lockstep/row.h"
#include "tests/support/properties.h"
#include "tests/support/usual_cases.h"

namespace csgsim::test {

namespace {

constexpr unsigned instructions = 8;                   ///< maximum per segment
constexpr std::size_t most_regions = 40;               ///< maximum per picture
constexpr std::uint64_t max_frame_clocks = 2'000'000;  ///< maximum per frame
constexpr unsigned seconds = 100;                      ///< time limit per machine, to detect deadlocks

constexpr int refused = 77;

using Property = bool (*)(const machines::Machine&, const Allowed&);

/// Steps the trees of small arrays, which take few steps.
systemc::EvaluatorForm form_for(const machines::Machine& machine) {
  return machine.array.width < 4 ? systemc::EvaluatorForm::stepped : systemc::EvaluatorForm::computed;
}

bool whole_pictures(const machines::Machine& machine, const Allowed& allowed) {
  const systemc::EvaluatorForm form = form_for(machine);
  return planes_agree(machine, instructions, form, allowed) &&
         planes_agree_in_sequences(machine, instructions, form, allowed);
}

bool lines(const machines::Machine& machine, const Allowed& allowed) {
  return scan_line_agrees(machine, instructions, allowed) &&
         scan_line_agrees_in_sequences(machine, instructions, allowed);
}

bool squares(const machines::Machine& machine, const Allowed& allowed) {
  return squares_agree(machine, instructions, form_for(machine), allowed);
}

bool memory(const machines::Machine& machine, const Allowed& allowed) {
  return memory_agrees(machine, instructions, allowed);
}

const std::map<std::string, Property> properties{{"frame-buffer", whole_pictures},
                                                 {"scan-line", lines},
                                                 {"pixel-square", squares},
                                                 {"multi-processor", nodes_agree},
                                                 {"bit-serial-memory", memory}};

const machines::Kind& kind_of(const std::string& name) {
  for (const machines::Kind* const kind : kinds::all())
    if (kind->name == name) return *kind;
  throw std::invalid_argument("there is no kind " + name);
}

/// Rejects Programs that do not run on the machine or take too long; records whether one was accepted.
class Affordable {
 public:
  explicit Affordable(const machines::Machine& machine) : machine_(machine) {}

  bool operator()(const isa::Program& program) {
    try {
      machines::check_runs_on(program, machine_);
    } catch (const InputError&) {
      return false;
    }
    const bool is = machines::time_frame(program, machine_).clocks <= max_frame_clocks;
    any_ = any_ || is;
    return is;
  }

  [[nodiscard]] bool any() const { return any_; }

 private:
  const machines::Machine& machine_;
  bool any_ = false;
};

/// Returns the exit code of the child.
int draw(const machines::Machine& machine, const Property& property, unsigned programs) {
  ::alarm(seconds);
  Affordable affordable(machine);
  const int code = property_exit_code(
      programs, [&] { return property(machine, [&](const isa::Program& program) { return affordable(program); }); });
  return code != 0 && !affordable.any() ? refused : code;
}

/// Returns 0, the exit code, or 128 plus the signal that ended the child, such as that of the alarm.
int in_a_process(const std::optional<machines::Machine>& machine, const Property& property, unsigned programs) {
  if (!machine || machines::regions(*machine).size() > most_regions) return refused;
  std::fflush(nullptr);
  const ::pid_t child = ::fork();
  if (child == 0) {
    std::freopen("/dev/null", "w", stdout);
    const int code = draw(*machine, property, programs);
    std::fflush(nullptr);
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int run(const std::string& name, std::uint64_t first, std::uint64_t last, unsigned programs) {
  const machines::Kind& kind = kind_of(name);
  const Property& property = properties.at(name);
  std::uint64_t drawn = 0;
  std::uint64_t failed = 0;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const std::optional<machines::Machine> machine = random_machine(kind, seed);
    testing::begin_case(fmt::format("{} {}", name, seed));
    const int code = in_a_process(machine, property, programs);
    if (code == refused) continue;
    ++drawn;
    if (code == 0) continue;
    ++failed;
    fmt::print("seed {}: {}{}: {}\n", seed, code > 128 ? "signal " : "exit code ", code > 128 ? code - 128 : code,
               figures_of(*machine));
  }
  fmt::print("{} of {} machines drew, {} of them failed\n", drawn, last - first + 1, failed);
  // The test is only meaningful if more than a third of the machines draw.
  const bool are_few = testing::draws_from_fixed_seed() && 3 * drawn <= last - first + 1;
  return failed == 0 && !are_few ? 0 : 1;
}

}  // namespace

}  // namespace csgsim::test

int main(int argc, char** argv) {
  try {
    if (argc != 5) throw std::invalid_argument("give a kind, the first and the last seed, and a number of Programs");
    return csgsim::test::run(argv[1], std::stoull(argv[2]), std::stoull(argv[3]),
                             static_cast<unsigned>(std::stoul(argv[4])));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}
