#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <string>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/observe/frame.h"

/// What C++ has as Python has it.
namespace csgsim::python {

namespace py = pybind11;

/// Dictionaries, lists, texts, numbers and None, in the order of the file.
py::object python_of(const nlohmann::ordered_json& json);

/// Rows, columns, and red, green and blue, of 8 bits.
py::array picture_of(const observe::Frame& frame, const isa::Program& program);

/// Distances from the eye along the view axis, model units, at each row and column; infinite where nothing is seen.
py::array depth_of(const observe::Frame& frame, const isa::Program& program);

/// Indices of primitives at each row and column, -1 where nothing is seen.
py::array owner_of(const observe::Frame& frame, const isa::Program& program);

/// The PNG file of a picture that is such an array. Throws UsageError for an array of another shape.
py::bytes png_of(const py::array_t<std::uint8_t, py::array::c_style>& picture);

/// One dictionary an instruction, in the order of the Program; the clocks are the machine's.
py::list instructions_of(const isa::Program& program, const machines::Machine& machine);

/// Name, description, kind, and each figure with its value, unit, provenance and source.
py::dict description_of(const machines::Machine& machine);

}  // namespace csgsim::python
