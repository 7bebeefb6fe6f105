// Pictures to be drawn by studies, with all their inputs.
// Used by sweep and explore, and by the studies that draw on machines.
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

/// A model, read-only and shared by threads.
struct Subject {
  model::Tree tree;
  facet::Geometry scene;
  std::string hash;  ///< hash of the bytes of the model's file
};

/// A picture with all its inputs. Jobs are independent of each other.
struct Job {
  std::shared_ptr<const Subject> subject;  ///< null if the model cannot be read
  view::Camera camera;
  view::Sampling sampling;
  machines::Machine machine;
  emit::Options options;
  Inputs inputs;
  std::string reason{};  ///< escaped reason why it cannot be drawn; empty if none is known
};

/// Throws InputError if the model does not fit the machine.
isa::Program compile(const Job& job);

/// Creates jobs. Reads a model once for all jobs that draw the same facets and quadrics of it.
class JobMaker {
 public:
  /// Creates a job with the options that `csgsim render` would use. If the model cannot be read or viewed, the job
  /// holds the reason. Throws InputError for invalid machines.
  Job make_job(const session::ModelRequest& options);

 private:
  /// A model, or the reason why it cannot be read.
  struct Read {
    std::shared_ptr<const Subject> subject;
    std::string reason;
    std::string hash;  ///< hash of the files; if they cannot be read, of the readable bytes and the reason
  };
  /// The data on which facets and quadrics depend, without the options that all machines of a study share.
  using Key = std::tuple<std::string, std::uint32_t, std::uint32_t, std::string>;

  static Key key(const session::ModelRequest& options, const machines::Machine& machine);
  static Read read(const session::ModelRequest& options, const machines::Machine& machine);

  std::map<Key, Read> read_;
};

}  // namespace csgsim::studies
