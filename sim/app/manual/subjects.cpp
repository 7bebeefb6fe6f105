#include "sim/app/manual/subjects.h"

#include <limits>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/text.h"
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
