#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/prints.h"
#include "hw/base/text.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/paths.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/design/meter.h"
#include "sim/studies/groups.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/study.h"
#include "sim/studies/sweep/options.h"
#include "sim/studies/sweep/show.h"

namespace csgsim::studies {

namespace {

using Rows = std::span<const SweepRow>;

/// Whether all machines draw the same surfaces of each model: all faceted, or all curved where possible.
bool have_equal_pictures(Rows rows) {
  std::map<std::string, std::uint64_t> halfspaces;
  return std::ranges::all_of(rows, [&](const SweepRow& row) {
    return !row.is_compiled() ||
           halfspaces.try_emplace(row.point.model, row.halfspaces).first->second == row.halfspaces;
  });
}

[[noreturn]] void refuse_pictures(Rows rows, const std::vector<WrongPicture>& wrong, bool are_read) {
  const PointNames names(rows);
  print_text("\n");
  for (const WrongPicture& one : wrong) {
    const std::string what = one.reference ? "the picture differs from that of " + names.name(*one.reference)
                                           : "a linear expression does not fit its width";
    print_text(fmt::format("WRONG: {}, {}: {}\n", one.point.model, names.name(one.point), what));
  }
  throw_inconsistent_results(fmt::format("{} of {} pictures are wrong", wrong.size(), rows.size()), are_read);
}

class Sweep : public StudyOf<SweepRow> {
 public:
  void add_options(session::OptionList& command) override { options_.add_to(command); }
  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override {
    return session::input_files(options_.models, session::parse_words(options_.machines));
  }
  [[nodiscard]] std::set<std::string> varied_options() const override {
    return {"strategy", "stack-bits", "z-bits", "colouring", "curves", "pruning", "machines", "memory-bits", "no-draw"};
  }

  std::vector<PointRequest> request_points() override {
    JobMaker maker;
    std::vector<PointRequest> requested;
    for (const session::ModelRequest& design : options_.designs()) {
      jobs_.push_back(maker.make_job(design));
      DesignPoint& point = points_.emplace_back(point_of(design, jobs_.back().machine.picture));
      point.memory_bits = design.memory_bits;
      requested.push_back({point_cells<SweepRow>(point), jobs_.back().inputs});
    }
    return requested;
  }

  /// A row without a picture is insufficient if pictures are requested.
  [[nodiscard]] bool has_requested_results(std::size_t /*point*/, const std::string& row) const override {
    if (options_.no_draw) return true;
    return !row.ends_with(",,");  // the last two columns, picture and reason, are empty
  }

  void print() const override {
    const Rows all = rows();
    for (const Rows model : group_by_model(all)) print_sweep(model);
    const bool has_drawn = !options_.no_draw && std::ranges::any_of(all, &SweepRow::is_compiled);
    if (!has_drawn || !wrong_pictures(all).empty()) return;
    print_text(
        fmt::format("\nAll pictures of a model with the same {} are identical.\n",
                    have_equal_pictures(all) ? "size and z bits" : "size, z bits and surfaces, curved or faceted,"));
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    std::vector<plots::Plot> all;
    PlotNames names;
    for (const Rows model : group_by_model(Rows(rows()))) {
      for (plots::Plot& plot : plots_of_sweep(model, names.next(plot_stem(model.front().point.model))))
        all.push_back(std::move(plot));
    }
    return all;
  }

  [[nodiscard]] std::string page_title() const override { return "Clocks against memory bits"; }

  [[nodiscard]] PageSubject page_subject() const override {
    return page_subject_of_models(options_.models, options_.view, options_.machines);
  }

  void refuse() const override {
    const Rows all = rows();
    if (std::ranges::none_of(all, &SweepRow::is_compiled) && group_by_model(all).size() == 1)
      throw InputError(all.front().reason);
    if (const std::vector<WrongPicture> wrong = wrong_pictures(all); !wrong.empty())
      refuse_pictures(all, wrong, are_read());
    refuse_failed_models(all, "sweep.csv");
  }

 protected:
  [[nodiscard]] SweepRow measure_point(std::size_t point) override {
    return SweepRow(measure_picture(points_[point], jobs_[point], !options_.no_draw));
  }

 private:
  SweepOptions options_;
  std::vector<DesignPoint> points_;
  std::vector<Job> jobs_;
};

}  // namespace

extern const StudyRow sweep_row{
    .name = "sweep",
    .does = "Show the clocks saved by memory bits: every strategy with every number of bits, in parallel",
    .example =
        "  csgsim sweep carburettor.csg --camera 220,-255,135,2,0,5 -o carburettor-sweep\n"
        "  csgsim sweep *.csg --strategy bits --stack-bits 3..12 --no-draw -o table_6_1\n"
        "  csgsim sweep a.csg b.csg --strategy stack,list --z-bits 16,20 --colouring rebroadcast,field -o out\n"
        "  csgsim sweep a.csg --strategy list --pruning all,no-space,no-picture,no-separation,none -o out\n"
        "Lists are separated by commas, ranges are written 3..8; every combination is a point. Each result is written "
        "to\n"
        "sweep.csv immediately; after an interruption, the same command resumes, and with other ranges it measures "
        "only "
        "the new points.",
    .plots = "for each model plots (.png, .svg) of scan conversions, clocks, bits and memory",
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Sweep>()); }};

}  // namespace csgsim::studies
