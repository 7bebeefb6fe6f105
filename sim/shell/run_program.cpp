#include "sim/shell/run_program.h"

#include <fmt/format.h>

#include "sim/shell/summary.h"

namespace csgsim::shell {

void run_program(const OptionList& options, const RunSubject& subject, const RunRequest& request, RunOutputs& outputs,
                 const Advice& advice, const Judge& judge, const CheckpointOptions& checkpoints) {
  const FinishedRun run = finish_run(options, subject, request, outputs, advice, judge, checkpoints);
  const observe::Report report = run.report(subject);
  print_summary(report);
  fmt::print("{}", run.verdict);
  print_words(report, run.picture, advice);
  if (options.watch.after) options.watch.after(run.stats_file);
}

}  // namespace csgsim::shell
