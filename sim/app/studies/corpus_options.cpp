#include "sim/app/studies/corpus_options.h"

#include <fmt/format.h>

#include <map>
#include <system_error>
#include <tuple>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/app/options.h"
#include "sim/app/paths.h"
#include "sim/app/read_by.h"
#include "sim/app/run_options.h"
#include "sim/app/studies/shard_run.h"
#include "sim/app/studies/subjects.h"
#include "sim/app/subject.h"
#include "sim/app/version.h"
#include "sim/study/ranges.h"

namespace csgsim::app {

namespace {

namespace fs = std::filesystem;

bool is_source_of(const fs::path& file, const std::vector<fs::path>& files) {
  return ends_in(file, ".scad") && std::ranges::find(files, fs::path(file).replace_extension(".csg")) != files.end();
}

std::vector<fs::path> models_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (auto entry = fs::recursive_directory_iterator(folder, error);
       !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (entry->is_regular_file() && has_model_name(entry->path())) files.push_back(entry->path());
  }
  if (error) throw InputError(fmt::format("{}: cannot be read ({})", printable(folder.native()), error.message()));
  std::ranges::sort(files);
  std::vector<fs::path> models;
  for (const fs::path& file : files) {
    if (!is_source_of(file, files)) models.push_back(file);
  }
  if (models.empty())
    throw InputError(printable(folder.native()) + ": there is no .csg or .scad file in it; name another folder");
  return models;
}

/// The options with which `csgsim render` would draw the point.
ModelOptions options_of(const CorpusOptions& options, const std::string& model, const std::string& machine) {
  ModelOptions one = options.view;
  one.model = model;
  one.machine = machine;
  return one;
}

study::CorpusJob job_of(const ModelOptions& one, const machines::Machine& machine, const ReadSubject& read) {
  const study::Inputs inputs{read.hash, study::hash_of(machine), version_and_build()};
  study::CorpusJob job{{{escaped(one.model), escaped(one.machine)}, inputs},
                       read.subject,
                       {},
                       sampling_of(one, machine),
                       machine,
                       emit_options_of(one),
                       read.reason};
  if (!read.subject) return job;
  try {
    job.camera = camera_of(one, machine, read.subject->tree, read.subject->scene);
  } catch (const InputError& error) {
    job.reason = escaped(error.what());
  }
  return job;
}

}  // namespace

std::vector<std::string> corpus_files(const std::vector<std::string>& names) {
  std::vector<std::string> models;
  const auto add = [&](const std::string& model) {
    if (std::ranges::find(models, model) == models.end()) models.push_back(model);
  };
  for (const std::string& name : names) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      add(name);
      continue;
    }
    for (const fs::path& file : models_in(name)) add(file.native());
  }
  return models;
}

std::vector<study::CorpusJob> corpus_jobs(const CorpusOptions& options) {
  std::map<SubjectKey, ReadSubject> subjects;
  std::vector<study::CorpusJob> jobs;
  const std::vector<std::string> machines = study::parse_words(options.machines);
  for (const std::string& model : corpus_files(options.models)) {
    for (const std::string& name : machines) {
      const ModelOptions one = options_of(options, model, name);
      const machines::Machine machine = machine_of(one);
      const auto [place, is_new] = subjects.try_emplace(subject_key(one, machine));
      if (is_new) place->second = read_subject(one, machine);
      jobs.push_back(job_of(one, machine, place->second));
    }
  }
  return jobs;
}

void CorpusOptions::add_to(Command& command) {
  command.option("MODEL", models, "Models, .csg or .scad, and folders that hold such").required();
  command.option("-o,--output", folder, "Folder for corpus.csv, corpus.json and the plots").required().check(not_empty);
  command.option("--machines", machines, "List of machines, by name or .toml file")
      .check(is_read_by(study::parse_words));
  view.add_view_to(command);
  command.option("--z-bits", view.z_bits, "Bits of depth");
  command.option("--threads", threads, "Points that are measured at the same time").between(1U, most_threads);
  report.add_to(command);
  command.flag("--no-plots", no_plots, "Do without plots (gnuplot)");
  add_shard(command, shard);
  add_progress(command, progress);
}

}  // namespace csgsim::app
