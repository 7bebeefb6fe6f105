// Converts results to Python values.
// Used by module.cpp.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <string>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/observe/frame.h"

/// Conversion of C++ results to Python values.
namespace csgsim::python {

namespace py = pybind11;

/// Dictionaries, lists, texts, numbers and None, in the order of the JSON.
py::object to_python(const nlohmann::ordered_json& json);

/// An array of rows, columns and the channels red, green and blue, 8 bits each.
py::array picture_array(const observe::Frame& frame, const isa::Program& program);

/// An array of distances from the eye along the view axis in model units; infinite where nothing is visible.
py::array depth_array(const observe::Frame& frame, const isa::Program& program);

/// An array of primitive indices, -1 where nothing is visible.
py::array owner_array(const observe::Frame& frame, const isa::Program& program);

/// The PNG file of such a picture array. Throws UsageError for an array of another shape.
py::bytes to_png(const py::array_t<std::uint8_t, py::array::c_style>& picture);

/// One dictionary per instruction, in the order of the Program; the clocks are those of the machine.
py::list instruction_list(const isa::Program& program, const machines::Machine& machine);

/// Name, description and kind, and each parameter with its value, unit, provenance and source.
py::dict machine_description(const machines::Machine& machine);

}  // namespace csgsim::python
