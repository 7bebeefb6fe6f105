#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "host/facet/scene.h"
#include "host/view/camera.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::app {

/// Options of every command that compiles a model.
struct ModelOptions {
  std::string model;
  std::string machine = "pixel-planes-4";
  std::string size;
  std::optional<std::uint32_t> memory_bits;
  std::string camera;
  std::string projection = "ortho";
  bool view_all = false;
  std::optional<double> near;
  unsigned z_bits = 20;
  unsigned fraction_bits = 12;
  double edge_on = 1.0 / 256;
  std::optional<double> tolerance;
  std::string strategy = "stack";

  void add_to(CLI::App& command);
};

/// The machine with the array that the options ask for.
machines::Machine machine_of(const ModelOptions& options);

facet::Faceting faceting_of(const ModelOptions& options);
view::Sampling sampling_of(const ModelOptions& options, const machines::Machine& machine);
view::Camera camera_of(const ModelOptions& options, const machines::Machine& machine, const facet::Scene& scene);

/// Reads the model. Throws InputError.
model::Tree read_model(const ModelOptions& options);

/// A model read, faceted, seen and compiled.
struct CompiledModel {
  model::Tree tree;
  facet::Scene scene;
  view::Camera camera;
  isa::Program program;
};

/// Throws InputError, or CLI::ValidationError for options that make no sense.
CompiledModel compile_model(const ModelOptions& options, const machines::Machine& machine);

}  // namespace csgsim::app
