#include "sim/app/studies/subjects.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "host/emit/curves.h"
#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/text.h"
#include "hw/machines/regions.h"
#include "sim/study/hash.h"

namespace csgsim::app {

namespace {

constexpr InputKind model_bytes{"a file", std::numeric_limits<std::size_t>::max(), ""};

std::string hash_of_failure(const std::string& model, const std::string& reason) {
  study::Hash hash;
  try {
    hash.add(read_file(model, model_bytes));
  } catch (const InputError&) {
    hash.add("unread");
  }
  hash.add("\n" + reason);
  return hash.text();
}

}  // namespace

SubjectKey subject_key(const ModelOptions& options, const machines::Machine& machine) {
  // Facets may depend on what a pixel covers; which surfaces stay curved on what the machine can draw, and in how many
  // bits.
  const bool is_faceted = options.curves == emit::name_of(emit::Curves::facets) ||
                          (options.curves == emit::name_of(emit::Curves::automatic) && machine.evaluator_degree < 2);
  std::string curves;
  if (!is_faceted) {
    curves = fmt::format("{} {} {} {} {}", options.curves, machine.evaluator_degree,
                         machines::division(machine) ? machine.name : "", options.z_bits, options.fraction_bits);
  }
  return {options.model, machine.picture.width, machine.picture.height, std::move(curves)};
}

ReadSubject read_subject(const ModelOptions& options, const machines::Machine& machine) {
  try {
    ModelFile file = read_model_file(options);
    facet::Scene scene = facet::make_scene(file.tree, faceting_of(options, machine, file.tree));
    auto subject = std::make_shared<study::Subject>(study::Subject{std::move(file.tree), std::move(scene), file.hash});
    return {std::move(subject), "", std::move(file.hash)};
  } catch (const InputError& error) {
    return {nullptr, escaped(error.what()), hash_of_failure(options.model, error.what())};
  }
}

}  // namespace csgsim::app
