#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/study/measure.h"

namespace csgsim::study {

/// The measurements of a study as a CSV file that grows by a line a point, so that an interrupted study can go on: a
/// second start reads what is there. The first line is a comment that says what study it is.
class Table {
 public:
  /// Opens or begins a table. Throws InputError if the file holds another study (another `title`) or no table.
  Table(std::filesystem::path path, const std::string& title);

  [[nodiscard]] const std::vector<Measurement>& rows() const { return rows_; }
  [[nodiscard]] const Measurement* find(const Settings& settings) const;
  void add(const Measurement& measurement);

 private:
  void write(const std::string& text, bool append) const;

  std::filesystem::path path_;
  std::vector<Measurement> rows_;
};

nlohmann::ordered_json to_json(const Measurement& measurement);

}  // namespace csgsim::study
