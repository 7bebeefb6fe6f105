// The option --report and its page file.
// Used by sim/session, sim/app and sim/studies.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "hw/base/output_file.h"
#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/option_list.h"

namespace csgsim::report {
struct Context;
struct Page;
struct Picture;
struct StudyContext;
}  // namespace csgsim::report

namespace csgsim::session {

/// The option --report of commands that summarize their results on one page.
struct ReportOption {
  std::string file;

  void add_to(OptionList& options);
  [[nodiscard]] bool is_requested() const { return !file.empty(); }

  /// The command and its options, for the page. Empty until the command line has been parsed.
  [[nodiscard]] report::Context context(std::span<const machines::Machine> machines = {}) const;

 private:
  const OptionList* asked_ = nullptr;
};

/// The page's file. It is opened before the work starts, so that a bad name fails early.
class ReportFile {
 public:
  /// Throws UsageError if the file is an input, InputError if it cannot be written. Does nothing if no page is
  /// requested.
  ReportFile(const ReportOption& option, std::span<const std::filesystem::path> inputs);

  [[nodiscard]] bool is_requested() const { return file_.has_value(); }
  void write(const report::Page& page);

 private:
  std::optional<OutputFile> file_;
};

/// A picture of the model drawn by the machine.
report::Picture picture_of(const ModelRequest& model, const machines::Machine& machine, const std::string& caption);

/// Context of a study's page, with a picture of the model drawn by the first machine.
report::StudyContext study_context(const ReportOption& option, const ModelRequest& model,
                                   std::span<const machines::Machine> machines);

/// Context of a study's page without a picture.
report::StudyContext plain_study_context(const ReportOption& option, const std::string& model,
                                         std::span<const machines::Machine> machines);

}  // namespace csgsim::session
