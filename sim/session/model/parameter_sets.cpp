#include "sim/session/model/parameter_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/nearest.h"
#include "sim/session/options/json_text.h"

namespace csgsim::session {

namespace {

constexpr InputKind sets_input{"a file of parameter sets, .json", std::size_t{16} << 20U,
                               "split it into several files"};

[[noreturn]] void refuse_sets(const std::string& file, const std::string& why) {
  throw InputError(fmt::format("{}: {}; name a file of parameter sets, as OpenSCAD's customizer saves it", file, why));
}

}  // namespace

void require_parameter_set(const std::string& file, const std::string& set) {
  nlohmann::ordered_json json;
  try {
    json = parse_json(read_file(file, sets_input), {});
  } catch (const JsonLimitError& error) {
    refuse_sets(file, error.what());
  } catch (const nlohmann::ordered_json::exception&) {
    refuse_sets(file, "not valid JSON");
  }
  if (!json.is_object() || !json.contains("parameterSets") || !json.at("parameterSets").is_object())
    refuse_sets(file, "it has no 'parameterSets'");
  std::vector<std::string> names;
  for (const auto& [name, values] : json.at("parameterSets").items()) names.push_back(name);
  if (names.empty()) refuse_sets(file, "it has no parameter set");
  if (std::ranges::find(names, set) == names.end())
    throw InputError(fmt::format("{}: {}", file, unknown_name_text("parameter set", set, names)));
}

}  // namespace csgsim::session
