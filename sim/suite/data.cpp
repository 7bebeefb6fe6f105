#include "sim/suite/data.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "sim/system/own_program.h"

namespace csgsim::suite {

namespace fs = std::filesystem;

namespace {

constexpr InputKind data_file{"a file of the benchmark suite", std::size_t{256} << 20U, "it is not one of csgsim's"};
constexpr InputKind results_file{"a .csv file of results", std::size_t{16} << 20U, "divide it"};
constexpr const char* list_file = "suite.toml";

/// The folder beside the program: in the build tree, or in the installation.
fs::path own_folder() {
  const fs::path program = fs::path(system::own_program()).parent_path();
  const auto places = std::to_array<fs::path>({program / "benchmark", program / CSGSIM_SUITE_FROM_PROGRAM});
  std::error_code unused;
  for (const fs::path& place : places)
    if (fs::exists(place / list_file, unused)) return place.lexically_normal();
  throw InputError(places.back().lexically_normal().native() +
                   ": the benchmark suite is not there; install csgsim completely (cmake --install), or name the "
                   "suite's folder with --suite");
}

}  // namespace

Data::Data(const fs::path& folder) : folder_(folder.empty() ? own_folder() : folder) {
  const fs::path list = folder_ / list_file;
  suite_ = read_suite(read_suite_file(list), list.native());
  expected_ = read_results_file(folder_ / "expected.csv");
}

fs::path Data::program_file(const Case& one) const { return folder_ / "programs" / (one.name + ".txt"); }
fs::path Data::picture_file(const Case& one) const { return folder_ / "pictures" / (one.name + ".png"); }
fs::path Data::model_file(const Case& one) const { return folder_ / "models" / fs::path(one.model).filename(); }

bool Data::runs_stored(const std::string& machine) const {
  const machines::Kind* const kind = kinds::load(machine).kind;
  return std::ranges::any_of(suite_.stored, [&](const std::string& name) { return kinds::load(name).kind == kind; });
}

std::vector<Row> read_results_file(const fs::path& path) {
  return read_results(read_file(path, results_file), path.native());
}

std::string read_suite_file(const fs::path& path) { return read_file(path, data_file); }

}  // namespace csgsim::suite
