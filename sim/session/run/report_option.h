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

/// The option --report of commands that show what they did as one page.
struct ReportOption {
  std::string file;

  void add_to(OptionList& options);
  [[nodiscard]] bool asked() const { return !file.empty(); }

  /// What the command was told: nothing before the command line has been read.
  [[nodiscard]] report::Context context(std::span<const machines::Machine> machines = {}) const;

 private:
  const OptionList* asked_ = nullptr;
};

/// The page's file: opened before there is anything to tell, so that nothing is done in vain.
class ReportFile {
 public:
  /// Throws UsageError for one that is an input, InputError for one that cannot be written. Nothing if none is asked
  /// for.
  ReportFile(const ReportOption& option, std::span<const std::filesystem::path> inputs);

  [[nodiscard]] bool asked() const { return file_.has_value(); }
  void write(const report::Page& page);

 private:
  std::optional<OutputFile> file_;
};

/// The model as the machine draws it.
report::Picture picture_of(const ModelRequest& model, const machines::Machine& machine, const std::string& caption);

/// What a study's page tells beside its points, with a picture of the model on the first machine, which is drawn for
/// it.
report::StudyContext study_context(const ReportOption& option, const ModelRequest& model,
                                   std::span<const machines::Machine> machines);

/// The same without a picture.
report::StudyContext plain_study_context(const ReportOption& option, const std::string& model,
                                         std::span<const machines::Machine> machines);

}  // namespace csgsim::session
