#include "sim/studies/json_export.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "hw/base/output_file.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"

namespace csgsim::studies {

void JsonExport::add_to(session::OptionList& command, const std::string& action) {
  command.option("--json", file_, action + " to a .json file, or - for standard output").check(session::not_empty);
}

void JsonExport::write(std::span<const std::filesystem::path> inputs,
                       const std::function<nlohmann::ordered_json()>& make_facts, std::string_view list_name,
                       const std::function<void(const Put& put)>& write_items) const {
  if (file_.empty()) return;
  session::refuse_clashes(inputs, std::to_array<std::filesystem::path>({file_}));
  OutputFile file(file_);
  std::string begin = make_facts().dump();
  begin.back() = ',';
  file.write(fmt::format("{}\"{}\":[", begin, list_name));
  const char* between = "\n";
  write_items([&](const nlohmann::ordered_json& item) {
    file.write(between + item.dump());
    between = ",\n";
  });
  file.write("\n]}\n");
  file.commit();
}

}  // namespace csgsim::studies
