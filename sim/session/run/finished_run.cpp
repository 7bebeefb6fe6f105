#include "sim/session/run/finished_run.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "hw/isa/facts.h"
#include "sim/report/run_page.h"
#include "sim/session/options/progress.h"
#include "sim/session/run/explain.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/run_outputs.h"

namespace csgsim::session {

namespace {

/// The configuration if it is wanted, else null: it hashes the input files, so they are read once more.
nlohmann::ordered_json wanted_configuration(const OptionList& options, const RunSubject& subject,
                                            const RunRequest& request, bool is_wanted) {
  if (!is_wanted && request.stats.empty() && !request.report.is_requested() && !options.watch.before) return nullptr;
  nlohmann::ordered_json configuration = configuration_of(options, subject);
  if (options.watch.before) options.watch.before(configuration);
  return configuration;
}

FinishedRun run_simulation(const RunSubject& subject, const RunRequest& request, const CheckpointOptions& checkpoints) {
  const isa::Program& program = subject.program;
  const machines::Machine& machine = subject.machine;
  RunObservers observers{observe::FrameObserver(program), observe::StatsObserver(program), {}};
  const bool shows = shows_progress(request.progress);
  observe::LongWork work = long_run_warning(request.level);
  if (shows || request.level != "functional") observers.progress.emplace(program, machine).warn(work, shows);
  const std::unique_ptr<engine::Engine> engine =
      make_engine(machine, request.level, request.threads, evaluator_form(request.evaluator, request.level));
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

/// Depth and fraction bits that were chosen to meet --max-wrong-pixels; empty without that option.
GivenTexts chosen_bits(const OptionList& options, const isa::Program& program) {
  if (!options.is_given("max-wrong-pixels")) return {};
  const isa::CompileFacts& compile = program.facts->compile;
  return {{"z-bits", std::to_string(compile.z_bits)}, {"fraction-bits", std::to_string(compile.fraction_bits)}};
}

report::Page page_of(const OptionList& options, const FinishedRun& run, const RunSubject& subject,
                     const ReportOption& option) {
  std::optional<story::HalfspaceFinder> halfspaces;
  if (subject.halfspaces) halfspaces.emplace(subject.halfspaces());
  report::Context context = option.context();
  context.explain = explain_command(options, subject.inputs.front().native(), chosen_bits(options, subject.program));
  return report::run_page(run.stats_file, run.picture, subject.program, subject.machine, context,
                          halfspaces ? &*halfspaces : nullptr);
}

FinishedRun finish(const OptionList& options, const RunSubject& subject, const RunRequest& request, RunOutputs& outputs,
                   const Advice& advice, const Judge& judge, const CheckpointOptions& checkpoints, bool is_configured) {
  const isa::Program& program = subject.program;
  nlohmann::ordered_json configuration = wanted_configuration(options, subject, request, is_configured);
  FinishedRun run = run_simulation(subject, request, checkpoints);
  run.knobs = measure_parameter_knobs(advice, program, subject.machine, run.result);
  run.stats_file = observe::to_json(run.report(subject));
  if (!configuration.is_null()) insert_configuration(run.stats_file, std::move(configuration), run.picture);
  if (judge) run.verdict = judge(run.picture, run.stats_file["accuracy"]);
  outputs.write_pictures(run.picture, program);
  outputs.write_stats(run.stats_file.dump(2) + "\n");
  if (request.report.is_requested()) outputs.write_report(page_of(options, run, subject, request.report));
  outputs.commit();
  return run;
}

}  // namespace

FinishedRun finish_run(const OptionList& options, const RunSubject& subject, const RunRequest& request,
                       RunOutputs& outputs, const Advice& advice, const Judge& judge,
                       const CheckpointOptions& checkpoints, bool is_configured) {
  evaluator_form(request.evaluator, request.level);
  announce_memory(subject.machine, subject.program.shape, request.level);
  return with_memory_for_run({&subject.program, 1}, subject.machine.array, [&] {
    return finish(options, subject, request, outputs, advice, judge, checkpoints, is_configured);
  });
}

}  // namespace csgsim::session
