#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/isa/instruction_numbers.h"
#include "hw/isa/program_file.h"
#include "hw/isa/text.h"
#include "hw/kinds/load.h"
#include "sim/cycle/elaboration.h"
#include "sim/python/call.h"
#include "sim/python/interruptible.h"
#include "sim/python/values.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/usage.h"
#include "sim/session/options/version.h"
#include "sim/session/run/explain.h"
#include "sim/session/run/render.h"
#include "sim/session/run/run_file.h"
#include "sim/session/run/run_outputs.h"
#include "sim/studies/accuracy/choose_bits.h"
#include "sim/studies/rows.h"
#include "sim/studies/runner.h"

/// csgsim._csgsim, the native part of the Python package csgsim, whose __init__.py documents the interface.
namespace csgsim::python {

namespace {

using Text = std::optional<std::string>;

/// A Program and the machine that it is for.
struct HeldProgram {
  isa::Program program;
  machines::Machine machine;
};
using Held = std::shared_ptr<HeldProgram>;

Held make_held(isa::Program program, machines::Machine machine) {
  return std::make_shared<HeldProgram>(HeldProgram{std::move(program), std::move(machine)});
}

/// A picture and its counts.
struct DrawnRun {
  observe::Frame frame;  ///< shows the requested surfaces
  nlohmann::ordered_json stats;
  Held held;
};

DrawnRun make_drawn(session::FinishedRun run, const session::RunRequest& options, Held held) {
  const bool is_of_opaque = options.surface == "opaque";
  return {is_of_opaque ? observe::with_opaque_surfaces(std::move(run.picture)) : std::move(run.picture),
          std::move(run.stats_file), std::move(held)};
}

/// A request filled from a call.
template <class Request>
struct Read {
  Request request;
  session::OptionList list;

  explicit Read(const Call& call) : list(call.command) {
    request.add_to(list);
    give(call, list);
  }
};

/// SystemC allows one simulation per process, so clocked runs wait for each other.
std::unique_lock<std::mutex> lock_if_clocked(const session::RunRequest& options) {
  static std::mutex clocked;
  return options.level == "cycle" ? std::unique_lock(clocked) : std::unique_lock<std::mutex>();
}

DrawnRun render_model(const Call& call, const Text& text) {
  Read<session::RenderRequest> read(call);
  session::RenderRequest& request = read.request;
  session::RunOutputs outputs(request.run, request.model.inputs());
  session::Compiled compiled = session::compile(request, studies::choose_bits, {.text = text});
  const std::unique_lock alone = lock_if_clocked(request.run);
  session::FinishedRun run =
      session::finish_run(read.list, compiled.subject(request), request.run, outputs,
                          session::advice_of(request, compiled), session::make_judge(request, compiled), {}, true);
  return make_drawn(std::move(run), request.run,
                    make_held(std::move(compiled.model.program), std::move(compiled.machine)));
}

Held compile_program(const Call& call, const Text& text) {
  session::RenderRequest request;
  request.model = Read<session::ModelRequest>(call).request;
  session::Compiled compiled = session::compile(request, studies::choose_bits, {.text = text});
  return make_held(std::move(compiled.model.program), std::move(compiled.machine));
}

DrawnRun run_program(const Call& call, const Held& program) {
  const Read<session::ProgramRequest> read(call);
  const session::ProgramRequest& request = read.request;
  session::refuse_misuse(request);
  session::RunOutputs outputs(request.run, request.files_read());
  session::LoadedProgram loaded =
      session::load(request, {.text = {}, .program = program ? &program->program : nullptr});
  const std::unique_lock alone = lock_if_clocked(request.run);
  session::FinishedRun run =
      session::finish_run(read.list, loaded.subject(), request.run, outputs,
                          session::advice_of(request, loaded.machine), {}, request.checkpoints, true);
  return make_drawn(std::move(run), request.run, make_held(std::move(loaded.program), std::move(loaded.machine)));
}

story::PixelExplanation explain_pixel(const Call& call, const Text& text, const Held& program) {
  const Read<session::ExplainRequest> read(call);
  const session::ContentReplacement in_place{text, program ? &program->program : nullptr};
  session::refuse_misuse(read.request, read.list, in_place);
  return session::explain(read.request, read.list, in_place);
}

/// The content of a study's JSON file.
nlohmann::ordered_json run_study(const Call& call) {
  const auto rows = studies::all();
  const auto row = std::ranges::find_if(rows, [&](const auto* one) { return one->name == call.command; });
  if (row == rows.end())
    throw session::UsageError("there is no study '" + call.command + "'; csgsim.studies() lists them");
  session::OptionList list(call.command);
  const std::shared_ptr<studies::StudyCommand> study_command = studies::add_library_study_options(list, **row);
  give(call, list);
  return nlohmann::ordered_json::parse(studies::run_study_to_json(*study_command));
}

py::dict to_dict(const DrawnRun& drawn) {
  py::dict dict;
  dict["picture"] = picture_array(drawn.frame, drawn.held->program);
  dict["depth"] = depth_array(drawn.frame, drawn.held->program);
  dict["owner"] = owner_array(drawn.frame, drawn.held->program);
  dict["stats"] = to_python(drawn.stats);
  dict["program"] = py::cast(drawn.held);
  return dict;
}

/// Options of a call in the form that Python passes.
using Options = std::vector<std::pair<std::string, Text>>;

py::tuple render(const std::vector<std::string>& operands, const Options& options, const Text& text) {
  const auto finished = run_interruptibly([&] { return render_model({"render", operands, options}, text); });
  return py::make_tuple(to_dict(finished.result), finished.warnings);
}

py::tuple compile(const std::vector<std::string>& operands, const Options& options, const Text& text) {
  auto finished = run_interruptibly([&] { return compile_program({"compile", operands, options}, text); });
  return py::make_tuple(std::move(finished.result), finished.warnings);
}

py::tuple run(const std::vector<std::string>& operands, const Options& options, const Held& program) {
  const auto finished = run_interruptibly([&] { return run_program({"run", operands, options}, program); });
  return py::make_tuple(to_dict(finished.result), finished.warnings);
}

py::tuple explain(const std::vector<std::string>& operands, const Options& options, const Text& text,
                  const Held& program) {
  const auto finished = run_interruptibly([&] { return explain_pixel({"explain", operands, options}, text, program); });
  return py::make_tuple(to_python(finished.result.json), finished.result.text, finished.warnings);
}

py::tuple study(const std::string& name, const std::vector<std::string>& operands, const Options& options) {
  const auto finished = run_interruptibly([&] { return run_study({name, operands, options}); });
  return py::make_tuple(to_python(finished.result), finished.warnings);
}

py::tuple load(const std::string& file) {
  session::refuse_model(file);
  auto finished = run_interruptibly([&] {
    isa::Program program = session::read_program(file);
    machines::Machine machine = session::machine_for(program, file, "", {});
    return make_held(std::move(program), std::move(machine));
  });
  return py::make_tuple(std::move(finished.result), finished.warnings);
}

void save(const Held& held, const std::string& file, bool is_text) {
  isa::save_program(held->program, file, is_text ? isa::ProgramForm::text : isa::ProgramForm::binary);
}

std::string text_of(const Held& held) {
  std::ostringstream text;
  isa::print(text, held->program);
  return std::move(text).str();
}

py::list field_list(const Held& held) {
  py::list rows;
  for (const isa::NamedField& named : held->program.facts->fields) {
    py::dict row;
    row["name"] = named.name;
    row["base"] = named.field.base;
    row["width"] = named.field.width;
    row["role"] = isa::name_of(named.role);
    rows.append(row);
  }
  return rows;
}

/// Names of session::Takes, in its order.
constexpr auto takes_names = std::to_array<const char*>({"flag", "whole number", "number", "text", "texts"});

py::list option_rows(const std::string& command) {
  py::list rows;
  for (const session::OptionValue& option : command_options(command)) {
    py::dict row;
    row["name"] = option.name;
    row["takes"] = takes_names.at(static_cast<std::size_t>(option.takes));
    row["is_operand"] = option.is_operand;
    row["default"] = option.values;
    row["meaning"] = option.meaning;
    rows.append(row);
  }
  return rows;
}

std::vector<std::string_view> study_names() {
  std::vector<std::string_view> names;
  for (const studies::StudyRow* const row : studies::all()) names.emplace_back(row->name);
  return names;
}

/// A class of the Python package, which lives as long as the process.
PyObject* error_class(const char* name) {
  return py::object(py::module_::import("csgsim._errors").attr(name)).release().ptr();
}

void translate(std::exception_ptr thrown) {
  static PyObject* const error = error_class("Error");
  static PyObject* const usage_error = error_class("UsageError");
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const session::UsageError& wrong) {
    PyErr_SetString(usage_error, wrong.what());
  } catch (const InputError& wrong) {
    PyErr_SetString(error, wrong.what());
  } catch (const cycle::ElaborationError& wrong) {
    PyErr_SetString(error, wrong.what());
  }
}

void define_program(py::module_& module) {
  py::class_<HeldProgram, std::shared_ptr<HeldProgram>>(module, "Program")
      .def("save", &save)
      .def("text", &text_of)
      .def("instructions", [](const Held& held) { return instruction_list(held->program, held->machine); })
      .def("__len__", [](const Held& held) { return csgsim::isa::first_instruction_numbers(held->program).back(); })
      .def("fields", &field_list)
      .def("primitives", [](const Held& held) { return held->program.facts->primitives; })
      .def("size", [](const Held& held) { return std::pair(held->program.shape.width, held->program.shape.height); })
      .def("memory_bits", [](const Held& held) { return held->program.shape.memory_bits; })
      .def("machine", [](const Held& held) { return machine_description(held->machine); });
}

}  // namespace

}  // namespace csgsim::python

PYBIND11_MODULE(_csgsim, module) {
  using namespace csgsim::python;
  py::register_local_exception_translator(&translate);
  define_program(module);
  module.def("version", &csgsim::session::version);
  module.def("render", &render);
  module.def("compile", &compile);
  module.def("run", &run);
  module.def("explain", &explain);
  module.def("study", &study);
  module.def("load", &load);
  module.def("options", &option_rows);
  module.def("studies", &study_names);
  module.def("machines", &csgsim::kinds::built_in_names);
  module.def("machine", [](const std::string& name, const std::vector<std::string>& changes) {
    return machine_description(csgsim::kinds::load(name, changes));
  });
  module.def("png", &to_png);
}
