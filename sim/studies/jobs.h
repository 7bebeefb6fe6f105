#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"
#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// A model, ready to be looked at by any number of threads.
struct Subject {
  model::Tree tree;
  facet::Geometry scene;
  std::string hash;  ///< of the bytes of the model's file
};

/// A picture with all that it is made from. Jobs do not depend on each other.
struct Job {
  std::shared_ptr<const Subject> subject;  ///< null where the model cannot be read
  view::Camera camera;
  view::Sampling sampling;
  machines::Machine machine;
  emit::Options options;
  Inputs inputs;
  std::string reason{};  ///< escaped(): why it cannot be drawn; empty as far as is known
};

/// Throws InputError where the model does not fit the machine.
isa::Program compile(const Job& job);

/// Makes jobs, of which each model is read once for all that draw the same facets and quadrics of it.
class JobMaker {
 public:
  /// With the options with which `csgsim render` would draw it. A model that cannot be read, or seen, is the job's
  /// reason. Throws InputError for machines.
  Job job_of(const session::ModelRequest& options);

 private:
  /// A model, or why it cannot be read.
  struct Read {
    std::shared_ptr<const Subject> subject;
    std::string reason;
    std::string hash;  ///< of what was read; of a model that cannot be, of its bytes, as far as there are any, and why
  };
  /// What facets and quadrics depend on, beside the options of a study that its machines share.
  using Key = std::tuple<std::string, std::uint32_t, std::uint32_t, std::string>;

  static Key key(const session::ModelRequest& options, const machines::Machine& machine);
  static Read read(const session::ModelRequest& options, const machines::Machine& machine);

  std::map<Key, Read> read_;
};

}  // namespace csgsim::studies
