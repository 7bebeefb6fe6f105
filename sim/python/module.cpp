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
#include "hw/isa/instruction_numbers.h"
#include "hw/isa/program_file.h"
#include "hw/isa/text.h"
#include "hw/kinds/load.h"
#include "sim/calls/explain.h"
#include "sim/calls/render.h"
#include "sim/calls/run.h"
#include "sim/cycle/elaboration.h"
#include "sim/python/call.h"
#include "sim/python/interruptible.h"
#include "sim/python/values.h"
#include "sim/shell/program_of.h"
#include "sim/shell/run_outputs.h"
#include "sim/shell/subject.h"
#include "sim/shell/usage.h"
#include "sim/shell/version.h"
#include "sim/studies/rows.h"
#include "sim/studies/runner.h"

/// csgsim._csgsim: what the Python package csgsim stands upon. Its __init__.py says what everything means.
namespace csgsim::python {

namespace {

using Text = std::optional<std::string>;

/// A Program, and the machine that it is for.
struct HeldProgram {
  isa::Program program;
  machines::Machine machine;
};
using Held = std::shared_ptr<HeldProgram>;

Held held_of(isa::Program program, machines::Machine machine) {
  return std::make_shared<HeldProgram>(HeldProgram{std::move(program), std::move(machine)});
}

/// A picture and what is told of it.
struct Drawn {
  observe::Frame frame;  ///< with the surfaces that were asked for
  nlohmann::ordered_json stats;
  Held held;
};

Drawn drawn_of(shell::FinishedRun run, const shell::RunOptions& options, Held held) {
  const bool is_of_opaque = options.surface == "opaque";
  return {is_of_opaque ? observe::of_opaque(std::move(run.picture)) : std::move(run.picture), std::move(run.stats_file),
          std::move(held)};
}

template <class Value>
Value taken(std::optional<Value> value) {
  if (!value) throw std::logic_error("the command line ran nothing");
  return *std::move(value);
}

/// What `work` gives of the command that is called, when the call has been read into its options.
template <class Options, class Work>
auto called(const Call& call, Options& options, const Work& work) {
  std::optional<decltype(work(std::declval<const shell::Command&>()))> result;
  carry_out(call, [&](shell::CommandLine& line) {
    shell::Command command = line.add(call.command, "", "");
    options.add_to(command);
    command.runs([&result, &work, command] { result = work(command); });
  });
  return taken(std::move(result));
}

/// SystemC has one simulation a process: threads wait for each other there.
std::unique_lock<std::mutex> alone_if_clocked(const shell::RunOptions& options) {
  static std::mutex clocked;
  return options.level == "cycle" ? std::unique_lock(clocked) : std::unique_lock<std::mutex>();
}

Drawn rendered(const Call& call, const Text& text) {
  calls::RenderOptions options;
  return called(call, options, [&](const shell::Command& command) {
    shell::RunOutputs outputs(options.run, options.model.inputs());
    calls::Compiled compiled = calls::compile(options, {.text = text});
    const std::unique_lock alone = alone_if_clocked(options.run);
    shell::FinishedRun run =
        shell::finish_run(command, compiled.subject(options), options.run, outputs, calls::advice_of(options, compiled),
                          calls::judge_of(options, compiled), {}, true);
    return drawn_of(std::move(run), options.run,
                    held_of(std::move(compiled.model.program), std::move(compiled.machine)));
  });
}

Held compiled(const Call& call, const Text& text) {
  calls::RenderOptions options;
  return called(call, options.model, [&](const shell::Command& /*command*/) {
    calls::Compiled compiled = calls::compile(options, {.text = text});
    return held_of(std::move(compiled.model.program), std::move(compiled.machine));
  });
}

Drawn ran(const Call& call, const Held& program) {
  calls::RunProgramOptions options;
  return called(call, options, [&](const shell::Command& command) {
    calls::refuse_misuse(options);
    shell::RunOutputs outputs(options.run, options.files_read());
    calls::Loaded loaded = calls::load(options, {.text = {}, .program = program ? &program->program : nullptr});
    const std::unique_lock alone = alone_if_clocked(options.run);
    shell::FinishedRun run =
        shell::finish_run(command, loaded.subject(), options.run, outputs, calls::advice_of(options, loaded.machine),
                          {}, options.checkpoints, true);
    return drawn_of(std::move(run), options.run, held_of(std::move(loaded.program), std::move(loaded.machine)));
  });
}

story::Answer explained(const Call& call, const Text& text, const Held& program) {
  calls::ExplainOptions options;
  return called(call, options, [&](const shell::Command& command) {
    const calls::InPlace in_place{text, program ? &program->program : nullptr};
    calls::refuse_misuse(options, command, in_place);
    return calls::explain(options, command, in_place);
  });
}

/// All that a study tells, as its JSON file has it.
nlohmann::ordered_json studied(const Call& call) {
  const auto rows = studies::all();
  const auto row = std::ranges::find_if(rows, [&](const auto* one) { return one->name == call.command; });
  if (row == rows.end()) throw shell::UsageError("there is no study '" + call.command + "'");
  std::optional<nlohmann::ordered_json> json;
  carry_out(call, [&](shell::CommandLine& line) {
    const std::shared_ptr<studies::StudyCommand> asked = studies::describe_for_caller(line, **row);
    asked->command.runs([&json, asked] { json = nlohmann::ordered_json::parse(studies::conduct(*asked)); });
  });
  return taken(std::move(json));
}

py::dict dict_of(const Drawn& drawn) {
  py::dict dict;
  dict["picture"] = picture_of(drawn.frame, drawn.held->program);
  dict["depth"] = depth_of(drawn.frame, drawn.held->program);
  dict["owner"] = owner_of(drawn.frame, drawn.held->program);
  dict["stats"] = python_of(drawn.stats);
  dict["program"] = py::cast(drawn.held);
  return dict;
}

/// Words of a call, as Python has them.
using Options = std::vector<std::pair<std::string, Text>>;

py::tuple render(const std::vector<std::string>& operands, const Options& options, const Text& text) {
  const auto told = interruptibly([&] { return rendered({"render", operands, options}, text); });
  return py::make_tuple(dict_of(told.result), told.warnings);
}

py::tuple compile(const std::vector<std::string>& operands, const Options& options, const Text& text) {
  auto told = interruptibly([&] { return compiled({"compile", operands, options}, text); });
  return py::make_tuple(std::move(told.result), told.warnings);
}

py::tuple run(const std::vector<std::string>& operands, const Options& options, const Held& program) {
  const auto told = interruptibly([&] { return ran({"run", operands, options}, program); });
  return py::make_tuple(dict_of(told.result), told.warnings);
}

py::tuple explain(const std::vector<std::string>& operands, const Options& options, const Text& text,
                  const Held& program) {
  const auto told = interruptibly([&] { return explained({"explain", operands, options}, text, program); });
  return py::make_tuple(python_of(told.result.json), told.result.text, told.warnings);
}

py::tuple study(const std::string& name, const std::vector<std::string>& operands, const Options& options) {
  const auto told = interruptibly([&] { return studied({name, operands, options}); });
  return py::make_tuple(python_of(told.result), told.warnings);
}

py::tuple load(const std::string& file) {
  shell::refuse_model(file);
  auto told = interruptibly([&] {
    isa::Program program = shell::read_program(file);
    machines::Machine machine = shell::machine_for(program, file, "", {});
    return held_of(std::move(program), std::move(machine));
  });
  return py::make_tuple(std::move(told.result), told.warnings);
}

void save(const Held& held, const std::string& file, bool is_text) {
  isa::save_program(held->program, file, is_text ? isa::ProgramForm::text : isa::ProgramForm::binary);
}

std::string text_of(const Held& held) {
  std::ostringstream text;
  isa::print(text, held->program);
  return std::move(text).str();
}

py::list fields_of(const Held& held) {
  py::list rows;
  for (const isa::NamedField& named : held->program.facts.fields) {
    py::dict row;
    row["name"] = named.name;
    row["base"] = named.field.base;
    row["width"] = named.field.width;
    row["role"] = isa::name_of(named.role);
    rows.append(row);
  }
  return rows;
}

/// As shell::Takes has them.
constexpr auto takes_names = std::to_array<const char*>({"flag", "whole number", "number", "text", "texts"});

py::list option_rows(const std::string& command) {
  py::list rows;
  for (const shell::OptionValue& option : options_of(command)) {
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

/// A class of the package's own that lives as long as the process.
PyObject* error_class(const char* name) {
  return py::object(py::module_::import("csgsim._errors").attr(name)).release().ptr();
}

void translate(std::exception_ptr thrown) {
  static PyObject* const error = error_class("Error");
  static PyObject* const usage_error = error_class("UsageError");
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const shell::UsageError& wrong) {
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
      .def("instructions", [](const Held& held) { return instructions_of(held->program, held->machine); })
      .def("__len__", [](const Held& held) { return csgsim::isa::first_numbers(held->program).back(); })
      .def("fields", &fields_of)
      .def("primitives", [](const Held& held) { return held->program.facts.primitives; })
      .def("size", [](const Held& held) { return std::pair(held->program.shape.width, held->program.shape.height); })
      .def("memory_bits", [](const Held& held) { return held->program.shape.memory_bits; })
      .def("machine", [](const Held& held) { return description_of(held->machine); });
}

}  // namespace

}  // namespace csgsim::python

PYBIND11_MODULE(_csgsim, module) {
  using namespace csgsim::python;
  py::register_local_exception_translator(&translate);
  define_program(module);
  module.def("version", &csgsim::shell::version);
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
    return description_of(csgsim::kinds::load(name, changes));
  });
  module.def("png", &png_of);
}
