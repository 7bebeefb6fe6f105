#include "sim/shell/run_program.h"

#include "sim/shell/summary.h"

namespace csgsim::shell {

void add_verbose_option(OptionList& options, RunRequest& request) {
  options.flag("--verbose", request.verbose, "Print also all counts, the most expensive primitives and all advice");
}

void run_program(const OptionList& options, const RunSubject& subject, const RunRequest& request, RunOutputs& outputs,
                 const Advice& advice, const Judge& judge, const CheckpointOptions& checkpoints) {
  const FinishedRun run = finish_run(options, subject, request, outputs, advice, judge, checkpoints);
  const observe::Report report = run.report(subject);
  print_run_summary(report, request.picture, advice, run.verdict, request.verbose);
  if (request.verbose) print_details(report, run.picture, advice);
  if (options.watch.after) options.watch.after(run.stats_file);
}

}  // namespace csgsim::shell
