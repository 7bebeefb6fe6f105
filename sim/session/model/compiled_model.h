// Reads, facets and compiles a model for a machine.
// Used by sim/app, sim/studies, sim/suite and sim/viewer.
#pragma once

#include <optional>
#include <string>

#include "host/csg/kept_results.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/setup/choices.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"
#include "sim/story/halfspaces.h"

namespace csgsim::session {

/// A model's file after reading.
struct ModelFile {
  model::Tree tree;
  std::string hash;  ///< hash of the bytes of the file and of the scene
};

/// Reads the model, or `replacement`, a text in place of the file's content. Throws InputError.
ModelFile read_model_file(const ModelRequest& request, const std::optional<std::string>& replacement = {});
/// The model's tree alone; otherwise like read_model_file().
model::Tree read_model(const ModelRequest& request);

/// A model that has been read, faceted, viewed and compiled.
struct CompiledModel {
  std::string hash;  ///< hash of the files that were read
  model::Tree tree;
  setup::Choices choices;
  facet::Geometry scene;
  view::Camera camera;
  isa::Program program;
};

/// The model with its half-spaces and camera, without a Program. Throws as compile_model does.
CompiledModel facet_model(const ModelRequest& request, const machines::Machine& machine);

/// Reads and compiles the model. Throws InputError, or UsageError for invalid options.
CompiledModel compile_model(const ModelRequest& request, const machines::Machine& machine);
/// Compiles a model that has been read.
CompiledModel compile_model(ModelFile file, setup::Choices choices, const machines::Machine& machine);

/// The model as its camera sees it.
view::View view_of(const CompiledModel& model);

/// A finder of the half-space to which an instruction of the model's Program belongs. The model must outlive the
/// finder.
story::HalfspaceFinder halfspaces_of(const CompiledModel& model);

/// The Program of the same facets for another camera, with the results kept from earlier frames (host/emit/compile.h).
/// Throws as compile_model does.
isa::Program compile_for_camera(const view::Camera& camera, const CompiledModel& model,
                                const machines::Machine& machine, csg::KeptResults* kept = nullptr);

}  // namespace csgsim::session
