#pragma once

#include <string>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"
#include "sim/story/halfspaces.h"

namespace csgsim::session {

/// A model's file as it was read.
struct ModelFile {
  model::Tree tree;
  std::string hash;  ///< of its bytes and the scene's
};

/// Reads the model. Throws InputError.
ModelFile read_model_file(const ModelRequest& request);

/// The same of a text that stands in the file's place.
ModelFile read_model_text(const ModelRequest& request, const std::string& text);
model::Tree read_model(const ModelRequest& request);

/// A model read, faceted, seen and compiled.
struct CompiledModel {
  std::string hash;  ///< of what was read
  model::Tree tree;
  facet::Geometry scene;
  view::Camera camera;
  isa::Program program;
};

/// Throws InputError, or UsageError for options that make no sense.
CompiledModel compile_model(const ModelRequest& request, const machines::Machine& machine);
CompiledModel compile_model(ModelFile file, const ModelRequest& request, const machines::Machine& machine);

/// As its camera sees it.
view::View view_of(const CompiledModel& model, const ModelRequest& request, const machines::Machine& machine);

/// Tells which half-space of the model an instruction of its Program is for. The model has to outlive it.
story::HalfspaceFinder halfspaces_of(const CompiledModel& model, const ModelRequest& request,
                                     const machines::Machine& machine);

/// The Program of the same facets, seen by another camera. Throws as compile_model does.
isa::Program compile_seen_by(const view::Camera& camera, const CompiledModel& model, const ModelRequest& request,
                             const machines::Machine& machine);

}  // namespace csgsim::session
