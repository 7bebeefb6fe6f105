#include "sim/studies/jobs.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "host/emit/compile.h"
#include "host/emit/curves.h"
#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/base/input_file.h"
#include "hw/base/text.h"
#include "hw/machines/hash.h"
#include "hw/machines/regions.h"
#include "sim/functional/clocks.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/options/version.h"

namespace csgsim::studies {

namespace {

constexpr InputKind model_bytes{"a file", std::numeric_limits<std::size_t>::max(), ""};

std::string hash_of_failure(const std::string& model, const std::string& reason) {
  Hash hash;
  try {
    hash.add(read_file(model, model_bytes));
  } catch (const InputError&) {
    hash.add("unread");
  }
  hash.add("\n" + reason);
  return hash.text();
}

}  // namespace

isa::Program compile(const Job& job) {
  const Subject& subject = *job.subject;
  const view::View view = view::make_view(subject.scene, subject.tree, job.camera, job.sampling);
  return emit::compile(subject.tree, subject.scene, view, job.machine, job.options,
                       [&](const isa::Program& program) { return functional::measure_clocks(program, job.machine); });
}

JobMaker::Key JobMaker::key(const session::ModelRequest& options, const machines::Machine& machine) {
  // Facets may depend on the size of a pixel. The choice of surfaces that stay curved depends on what the machine can
  // draw and on the number of bits.
  const bool is_faceted = options.curves == emit::name_of(emit::Curves::facets) ||
                          (options.curves == emit::name_of(emit::Curves::automatic) && machine.evaluator_degree < 2);
  std::string curves;
  if (!is_faceted) {
    curves = fmt::format("{} {} {} {} {}", options.curves, machine.evaluator_degree,
                         machines::division(machine) ? machine.name : "", options.z_bits, options.fraction_bits);
  }
  return {options.model, machine.picture.width, machine.picture.height, std::move(curves)};
}

JobMaker::Read JobMaker::read(const session::ModelRequest& options, const machines::Machine& machine) {
  try {
    session::ModelFile file = session::read_model_file(options);
    facet::Geometry scene = facet::make_geometry(file.tree, session::faceting_of(options, machine, file.tree));
    auto subject = std::make_shared<Subject>(Subject{std::move(file.tree), std::move(scene), file.hash});
    return {std::move(subject), "", std::move(file.hash)};
  } catch (const InputError& error) {
    return {nullptr, escaped(error.what()), hash_of_failure(options.model, error.what())};
  }
}

Job JobMaker::make_job(const session::ModelRequest& options) {
  machines::Machine machine = session::machine_of(options);
  const auto [place, is_new] = read_.try_emplace(key(options, machine));
  if (is_new) place->second = read(options, machine);
  const Read& read = place->second;
  Job job{read.subject,
          {},
          session::sampling_of(options, machine),
          std::move(machine),
          session::emit_options_of(options),
          {read.hash, {}, session::version_and_build()},
          read.reason};
  job.inputs.machine_hash = machines::hash_of(job.machine);
  if (!job.subject) return job;
  try {
    job.camera = session::camera_of(options, job.machine, job.subject->tree, job.subject->scene);
  } catch (const InputError& error) {
    job.reason = escaped(error.what());
  }
  return job;
}

}  // namespace csgsim::studies
