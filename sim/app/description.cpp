#include "sim/app/description.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "hw/base/output_file.h"

namespace csgsim::app {

namespace {

NLOHMANN_JSON_SERIALIZE_ENUM(ValueKind, {{ValueKind::none, nullptr},
                                         {ValueKind::words, "words"},
                                         {ValueKind::file, "file"},
                                         {ValueKind::machines, "machines"},
                                         {ValueKind::text, "text"}})

nlohmann::ordered_json json_of(const std::vector<DescribedOption>& options) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const DescribedOption& option : options) {
    nlohmann::ordered_json kind;
    to_json(kind, option.kind);
    all.push_back({{"name", option.name},
                   {"names", option.names},
                   {"type", option.type},
                   {"meaning", option.meaning},
                   {"default", option.usual},
                   {"range", option.range},
                   {"takes", kind},
                   {"words", option.words},
                   {"required", option.is_required},
                   {"several", option.takes_several}});
  }
  return all;
}

}  // namespace

std::string description_json(const Description& description) {
  nlohmann::ordered_json commands = nlohmann::ordered_json::array();
  for (const DescribedCommand& command : description.commands) {
    commands.push_back({{"name", command.name},
                        {"meaning", command.meaning},
                        {"footer", command.footer},
                        {"operands", json_of(command.operands)},
                        {"options", json_of(command.options)}});
  }
  const nlohmann::ordered_json json{{"program", description.program},          {"meaning", description.meaning},
                                    {"version", description.version},          {"date", description.date},
                                    {"options", json_of(description.options)}, {"commands", std::move(commands)}};
  return json.dump(2) + "\n";
}

void write_description(const Description& description, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail_to_write(folder, error);
  std::vector<DescriptionFile> files = manual_pages(description);
  files.push_back({description.program + ".bash", bash_completion(description)});
  files.push_back({"_" + description.program, zsh_completion(description)});
  files.push_back({description.program + ".fish", fish_completion(description)});
  files.push_back({description.program + ".json", description_json(description)});
  for (const DescriptionFile& file : files) write_file(std::filesystem::path(folder) / file.name, file.content);
}

}  // namespace csgsim::app
