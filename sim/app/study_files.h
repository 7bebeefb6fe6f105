#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "hw/base/output_file.h"

namespace csgsim::app {

/// The folder that a study writes to, made if it is not there. Throws InputError.
std::filesystem::path study_folder(const std::filesystem::path& folder);

/// Writes the points of a study: row_json(row) of each. Throws InputError.
template <class Rows, class RowJson>
void write_points(const std::filesystem::path& path, const std::string& title, const Rows& rows,
                  const RowJson& row_json) {
  nlohmann::ordered_json json{{"study", title}, {"points", nlohmann::ordered_json::array()}};
  for (const auto& row : rows) json["points"].push_back(row_json(row));
  write_file(path, json.dump(2) + "\n");
}

}  // namespace csgsim::app
