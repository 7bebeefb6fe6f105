#include "sim/session/run/finished_run.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "sim/report/run_page.h"
#include "sim/session/options/progress.h"
#include "sim/session/run/explain.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/run_outputs.h"

namespace csgsim::session {

namespace {

/// Worked out where somebody wants to see it: files are read once more for it.
nlohmann::ordered_json wanted_configuration(const OptionList& command, const RunSubject& subject,
                                            const RunRequest& options, bool is_wanted) {
  if (!is_wanted && options.stats.empty() && !options.report.asked() && !command.watch.before) return nullptr;
  nlohmann::ordered_json configuration = configuration_of(command, subject);
  if (command.watch.before) command.watch.before(configuration);
  return configuration;
}

FinishedRun simulated(const RunSubject& subject, const RunRequest& options, const CheckpointOptions& checkpoints) {
  const isa::Program& program = subject.program;
  const machines::Machine& machine = subject.machine;
  RunObservers observers{observe::FrameObserver(program), observe::StatsObserver(program), {}};
  const bool shows = shows_progress(options.progress);
  observe::LongWork work = long_run(options.level);
  if (shows || options.level != "functional") observers.progress.emplace(program, machine).warn(work, shows);
  const std::unique_ptr<engine::Engine> engine =
      make_engine(machine, options.level, options.threads, evaluator_form(options.evaluator, options.level));
  FinishedRun run;
  const auto begin = std::chrono::steady_clock::now();
  run.result = run_with_checkpoints(*engine, program, machine, checkpoints, observers);
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  observers.progress.reset();
  refuse_overflow(run.result);
  run.level = engine->level();
  run.stats = observers.stats.stats();
  run.picture = std::move(observers.frame).frame();
  if (!run.result.scanned_out.empty()) run.picture.colour = run.result.scanned_out;
  return run;
}

/// What --max-wrong-pixels chose.
GivenTexts chosen_bits(const OptionList& command, const isa::Program& program) {
  if (!command.is_given("max-wrong-pixels")) return {};
  const isa::CompileFacts& compile = program.facts.compile;
  return {{"z-bits", std::to_string(compile.z_bits)}, {"fraction-bits", std::to_string(compile.fraction_bits)}};
}

report::Page page_of(const OptionList& command, const FinishedRun& run, const RunSubject& subject,
                     const ReportOption& option) {
  std::optional<story::HalfspaceFinder> halfspaces;
  if (subject.halfspaces) halfspaces.emplace(subject.halfspaces());
  report::Context context = option.context();
  context.explain = explain_command(command, subject.inputs.front().native(), chosen_bits(command, subject.program));
  return report::run_page(run.stats_file, run.picture, subject.program, subject.machine, context,
                          halfspaces ? &*halfspaces : nullptr);
}

FinishedRun finish(const OptionList& command, const RunSubject& subject, const RunRequest& options, RunOutputs& outputs,
                   const Advice& advice, const Judge& judge, const CheckpointOptions& checkpoints, bool is_configured) {
  const isa::Program& program = subject.program;
  nlohmann::ordered_json configuration = wanted_configuration(command, subject, options, is_configured);
  FinishedRun run = simulated(subject, options, checkpoints);
  run.knobs = knobs_of(advice, program, subject.machine, run.result);
  run.stats_file = observe::to_json(run.report(subject));
  if (!configuration.is_null()) put_configuration(run.stats_file, std::move(configuration), run.picture);
  if (judge) run.verdict = judge(run.picture, run.stats_file["accuracy"]);
  outputs.write_pictures(run.picture, program);
  outputs.write_stats(run.stats_file.dump(2) + "\n");
  if (options.report.asked()) outputs.write_report(page_of(command, run, subject, options.report));
  outputs.commit();
  return run;
}

}  // namespace

FinishedRun finish_run(const OptionList& command, const RunSubject& subject, const RunRequest& options,
                       RunOutputs& outputs, const Advice& advice, const Judge& judge,
                       const CheckpointOptions& checkpoints, bool is_configured) {
  evaluator_form(options.evaluator, options.level);
  announce_memory(subject.machine, subject.program.shape, options.level);
  return with_memory_for_run({&subject.program, 1}, subject.machine.array, [&] {
    return finish(command, subject, options, outputs, advice, judge, checkpoints, is_configured);
  });
}

}  // namespace csgsim::session
