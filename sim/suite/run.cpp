#include "sim/suite/run.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/text.h"
#include "hw/machines/kind.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/version.h"
#include "sim/session/run/run_request.h"
#include "sim/suite/program_text.h"
#include "sim/system/child_process.h"
#include "sim/system/own_program.h"

namespace csgsim::suite {

namespace {

/// The command line that compiles the case.
session::ModelRequest request_of(const Data& data, const Job& job) {
  std::vector<std::string> words{data.model_file(*job.one).native()};
  const auto give = [&](const std::string& key, const std::string& value) {
    for (std::string& word : session::option_words(key, value)) words.push_back(std::move(word));
  };
  give("machine", job.machine);
  for (const auto& [key, value] : job.one->settings) give(key, value);
  return session::parse_model_request(words);
}

Prepared compile(const Data& data, const Job& job) {
  const session::ModelRequest request = request_of(data, job);
  machines::Machine machine = session::machine_of(request);
  isa::Program program = session::compile_model(request, machine).program;
  return {std::move(machine), std::move(program)};
}

Prepared load(const Data& data, const Job& job) {
  const std::filesystem::path file = data.program_file(*job.one);
  isa::Program program = isa::parse(read_suite_file(file), file.native());
  machines::Machine machine = session::load_machine(job.machine, {});
  machines::adopt_shape(machine, program);
  return {std::move(machine), std::move(program)};
}

void put_counts(Row& row, const session::DrawnRun& drawn) {
  const auto put = [&](std::string_view column, std::uint64_t number) { row.at(column) = std::to_string(number); };
  const observe::Cost& total = drawn.stats.total;
  put("clocks", drawn.result.clocks);
  put("shown_clocks", drawn.result.shown_clocks);
  put("interval_clocks", drawn.result.interval_clocks);
  put("pixel_operations", total.pixel_operations);
  put("enabled_operations", total.enabled);
  put("instructions", total.instructions);
  put("skipped", drawn.result.skipped);
  for (const isa::OpcodeInfo& info : isa::opcode_table)
    put(info.name, drawn.stats.by_opcode[static_cast<std::size_t>(info.opcode)].instructions);
}

}  // namespace

std::string hash_of(const observe::Frame& frame) {
  Hash hash;
  for (const std::uint32_t colour : frame.colour) {
    const std::array<char, 3> bytes{static_cast<char>(colour >> 16U & 0xffU), static_cast<char>(colour >> 8U & 0xffU),
                                    static_cast<char>(colour & 0xffU)};
    hash.add(std::string_view(bytes.data(), bytes.size()));
  }
  return hash.text();
}

std::string hash_of(std::string_view text) {
  Hash hash;
  hash.add(text);
  return hash.text();
}

Prepared prepare(const Data& data, const Job& job) {
  const bool is_stored = !job.compiles_always && data.runs_stored(job.machine);
  return is_stored ? load(data, job) : compile(data, job);
}

Row measure(const Prepared& prepared, const Job& job, bool shows_progress) {
  const session::DrawnRun drawn = session::draw(prepared.program, prepared.machine, job.level, shows_progress);
  Row row;
  row.at("case") = job.one->name;
  row.at("machine") = job.machine;
  row.at("simulator") = fmt::format("csgsim {}", session::version());
  row.at("level") = job.level;
  row.at("seconds") = fmt::format("{:.3f}", drawn.seconds);
  row.at("picture") = hash_of(drawn.frame);
  row.at("program") = hash_of(text_of(prepared.program));
  row.at("memory_bits") = std::to_string(used_bits(prepared.program));
  put_counts(row, drawn);
  return row;
}

Row measure_apart(const Data& data, const Job& job) {
  constexpr system::ChildLimits limits{
      .time = std::chrono::hours(10), .output = std::size_t{1} << 20U, .errors = std::size_t{1} << 16U};
  std::vector<std::string> words{system::own_program(), "bench-suite", job.one->name};
  for (const auto& [name, value] : {std::pair<std::string, std::string>("machines", job.machine),
                                    {"level", job.level},
                                    {"suite", data.folder().native()},
                                    {"results", "-"}})
    for (std::string& word : session::option_words(name, value)) words.push_back(std::move(word));
  if (job.compiles_always) words.emplace_back("--compile");
  const std::optional<system::ChildEnd> end =
      system::run_child(words, system::MemoryFile("input of csgsim bench-suite"), limits);
  if (!end) throw InputError("cannot run csgsim bench-suite: the csgsim executable has been moved or deleted");
  // The process also ends with 1 if the results differ from the expected ones.
  if (end->output.empty()) throw InputError(system::failure_text(*end, limits));
  std::vector<Row> rows = read_results(end->output, "csgsim bench-suite");
  if (rows.size() != 1) throw InputError(system::failure_text(*end, limits));
  return std::move(rows.front());
}

}  // namespace csgsim::suite
