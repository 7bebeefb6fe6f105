#include "sim/session/run/report_option.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/report/pictures.h"
#include "sim/report/study_pages.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/version.h"
#include "sim/session/run/configuration.h"
#include "sim/session/run/run_request.h"

namespace csgsim::session {

namespace {

/// The problem of a page's name, or an empty string.
std::string html_name_problem(const std::string& name) {
  return has_extension(name, ".html") ? "" : "'" + name + "' must end in .html";
}

}  // namespace

void ReportOption::add_to(OptionList& options) {
  options.option("--report", file, "Write a self-contained .html page: pictures, counts, interactive plots")
      .check(html_name_problem);
  asked_ = &options;
}

report::Context ReportOption::context(std::span<const machines::Machine> machines) const {
  const std::vector<std::string> arguments = asked_->arguments();
  report::Context context{shell_command(std::span(arguments).subspan(1)), {{"version", version_and_build()}}};
  for (const OptionValue& option : asked_->values()) {
    if (option.is_operand || option.values.empty()) continue;
    context.options.emplace_back("--" + option.name, fmt::format("{}", fmt::join(option.values, ",")));
  }
  for (const machines::Machine& machine : machines) context.machines.push_back(machine_json(machine));
  return context;
}

ReportFile::ReportFile(const ReportOption& option, std::span<const std::filesystem::path> inputs) {
  if (!option.is_requested()) return;
  refuse_clashes(inputs, std::to_array<std::filesystem::path>({option.file}));
  file_.emplace(option.file);
}

void ReportFile::write(const report::Page& page) {
  if (!file_) return;
  file_->write(report::to_html(page));
  file_->commit();
}

report::Picture picture_of(const ModelRequest& model, const machines::Machine& machine, const std::string& caption) {
  const isa::Program program = compile_model(model, machine).program;
  return report::picture_of(draw(program, machine).frame, program, caption, "The model: " + caption);
}

report::StudyContext plain_study_context(const ReportOption& option, const std::string& model,
                                         std::span<const machines::Machine> machines) {
  return {option.context(machines), std::filesystem::path(model).filename().native(), std::nullopt, ""};
}

report::StudyContext study_context(const ReportOption& option, const ModelRequest& model,
                                   std::span<const machines::Machine> machines) {
  report::StudyContext context = plain_study_context(option, model.model, machines);
  machines::Machine machine = machines.front();
  machine.array.memory_bits = std::max(machine.array.memory_bits, ample_memory_bits);
  try {
    context.picture = picture_of(model, machine, "The model drawn by " + machine.name);
  } catch (const InputError& error) {
    context.no_picture = error.what();
  }
  return context;
}

}  // namespace csgsim::session
