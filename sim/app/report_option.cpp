#include "sim/app/report_option.h"

#include <algorithm>
#include <array>
#include <utility>

#include "hw/base/error.h"
#include "sim/app/memory.h"
#include "sim/app/paths.h"
#include "sim/app/run_options.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/report/pictures.h"
#include "sim/study/measure.h"

namespace csgsim::app {

namespace {

/// What is wrong with a page's name, or nothing.
std::string html_name(const std::string& name) {
  return ends_in(name, ".html") ? "" : "'" + name + "' has to end in .html";
}

/// As the model is drawn whatever a study varies.
report::Picture picture_of(const ModelOptions& model, const machines::Machine& machine) {
  const isa::Program program = compile_model(model, machine).program;
  sim::FrameObserver frame(program);
  sim::Observer* const observer = &frame;
  const sim::RunResult result = with_memory_for_run({&program, 1}, machine.array, [&] {
    return sim::make_functional_engine(machine)->run(program, {&observer, 1});
  });
  refuse_overflow(result);
  return report::picture_of(frame.frame(), program, "The model as " + machine.name + " draws it", "The model");
}

}  // namespace

void ReportOption::add_to(Command& command) {
  command.option("--report", file, "One page of all this, .html: pictures, counts, plots to point at; needs no network")
      .check(html_name);
  command_ = command;
}

report::Context ReportOption::context() const {
  report::Context context{command_->typed(), {}};
  for (GivenOption& option : command_->settings())
    context.options.emplace_back("--" + option.name, std::move(option.value));
  return context;
}

ReportFile::ReportFile(const ReportOption& option, std::span<const std::filesystem::path> inputs) {
  if (!option.asked()) return;
  refuse_clashes(inputs, std::to_array<std::filesystem::path>({option.file}));
  file_.emplace(option.file);
}

void ReportFile::write(const report::Page& page) {
  if (!file_) return;
  file_->write(report::to_html(page));
  file_->commit();
}

report::StudyContext study_context(const ReportOption& option, const std::string& model) {
  return {option.context(), std::filesystem::path(model).filename().native(), std::nullopt, ""};
}

report::StudyContext study_context(const ReportOption& option, const ModelOptions& model, machines::Machine machine) {
  report::StudyContext context = study_context(option, model.model);
  machine.array.memory_bits = std::max(machine.array.memory_bits, study::ample_memory_bits);
  try {
    context.picture = picture_of(model, machine);
  } catch (const InputError& error) {
    context.no_picture = error.what();
  }
  return context;
}

}  // namespace csgsim::app
