#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/report/points.h"
#include "sim/studies/advise/options.h"
#include "sim/studies/advise/show.h"
#include "sim/studies/folder.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

namespace {

using Rows = std::span<const AdviceRow>;

/// What is recommended is drawn again, each with its own strategy, colouring and ALU.
void check_by_drawing(const AdviceJob& job, const AdviceRow& row, bool are_read) {
  if (draw_advice(job, row.point) == row) return;
  if (are_read)
    throw InputError("a choice that is recommended draws another picture than its row says; " + whose_fault(true));
  throw std::logic_error("a choice that is recommended draws another picture than was judged");
}

std::string picture_name(const AdviseOptions& options, const std::string& what) {
  std::string name = plot_stem(options.model.model) + "-" + what + ".png";
  for (char& c : name) c = c == ' ' ? '-' : c;
  return name;
}

Advice advice_of(const AdviseOptions& options, const session::OptionList& command, const AdviceQuestion& question,
                 Rows rows, bool are_read) {
  Advice advice{recommend(rows, question.wishes), {}};
  for (const Recommendation& one : advice.recommendations) {
    check_by_drawing(question.job, one.row, are_read);
    advice.commands.push_back(
        render_command(options, command, one.row, picture_name(options, recommendation_name(one.wish))));
  }
  const AdviceRow nearest = nearest_choices(rows, question.wishes, 1).front();
  if (meets_all(nearest, question.wishes)) return advice;
  check_by_drawing(question.job, nearest, are_read);
  advice.nearest = nearest;
  advice.nearest_command = render_command(options, command, nearest, picture_name(options, "nearest"));
  return advice;
}

/// A picture of each choice that is recommended, which may be the best by several wishes.
std::vector<report::Picture> pictures_of(const AdviseOptions& options, const Advice& advice) {
  std::vector<std::pair<AdviceRow, std::string>> choices;
  const auto add = [&](const AdviceRow& row, const std::string& name) {
    const auto known = std::ranges::find(choices, row, &std::pair<AdviceRow, std::string>::first);
    if (known == choices.end()) {
      choices.emplace_back(row, name);
    } else {
      known->second += ", " + name;
    }
  };
  for (const Recommendation& one : advice.recommendations) add(one.row, recommendation_name(one.wish));
  if (advice.nearest) add(*advice.nearest, "nearest to all wishes");
  std::vector<report::Picture> pictures;
  pictures.reserve(choices.size());
  for (const auto& [row, name] : choices) pictures.push_back(picture_of(options, row, name));
  return pictures;
}

constexpr report::PointColumn advise_columns[] = {{"used_bits", "bits in all"},
                                                  {"z_bits", "z bits"},
                                                  {"fraction_bits", "fraction bits"},
                                                  {"colour_bits", "colour bits"},
                                                  {"colour_error", "colour error of 255"},
                                                  {"strategy", "strategy"},
                                                  {"stack_bits", "stack bits"},
                                                  {"colouring", "colouring"},
                                                  {"alu_bits", "ALU bits"},
                                                  {"clocks", "clocks"},
                                                  {"frames_per_second", "frames a second"},
                                                  {"wrong", "wrong pixels"}};

report::Table wishes_table(const report::Json& data) {
  constexpr std::pair<const char*, const char*> rows[] = {{"memory bits a pixel, at most", "/wishes/max_bits"},
                                                          {"wrong pixels, at most", "/wishes/max_wrong_pixels"},
                                                          {"frames a second, at least", "/wishes/min_fps"},
                                                          {"bits of colour, at least", "/wishes/min_colour_bits"}};
  report::Table table{"Wishes", {"wish", "value"}, {}};
  for (const auto& [name, at] : rows) table.rows.push_back({{name}, report::cell(data, at)});
  return table;
}

/// Pointers of what is recommended, and of the nearest choice where there is one.
std::vector<std::string> recommended(const report::Json& data) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < data["recommendations"].size(); ++i)
    all.push_back("/recommendations/" + std::to_string(i));
  if (data.contains("nearest")) all.emplace_back("/nearest");
  return all;
}

report::Cell name_of(const report::Json& data, const std::string& at) {
  const report::Cell what = report::cell(data, at + "/what");
  return what.at.empty() ? report::Cell{"nearest to all wishes"} : what;
}

report::Table recommendations_table(const report::Json& data) {
  report::Table table{"The best by each wish", {"best by", "meets all wishes", "misses its own by"}, {}};
  for (const report::PointColumn& column : advise_columns) table.columns.emplace_back(column.title);
  for (const std::string& at : recommended(data)) {
    const bool is_nearest = at == "/nearest";
    report::Row row{name_of(data, at),
                    is_nearest ? report::cell(data, "/meets_all") : report::cell(data, at + "/meets_all"),
                    is_nearest ? report::Cell{} : report::cell(data, at + "/missed_by")};
    for (const report::PointColumn& column : advise_columns)
      row.push_back(report::cell(data, at + "/point/" + column.key));
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table commands_table(const report::Json& data) {
  report::Table table{"Commands that render them", {"best by", "command"}, {}, true};
  for (const std::string& at : recommended(data))
    table.rows.push_back({name_of(data, at), report::cell(data, at + "/command")});
  return table;
}

/// What a page says of the recommendations.
report::Section recommendations(const report::Json& data, std::uint64_t searched, std::uint64_t refused,
                                std::vector<report::Picture> pictures) {
  const char* const outcome =
      data["meets_all"].get<bool>()
          ? "Each of these is the best by one wish of the choices that meet the others."
          : "No choice meets all wishes. Each of these is the best by one wish of the choices that meet the others; "
            "what it misses its own wish by is what is in the way.";
  report::Section section{"Recommendations",
                          {report::Paragraph{fmt::format("{} choices were searched; {} of them cannot be drawn.",
                                                         grouped(searched), grouped(refused))},
                           report::Paragraph{outcome}}};
  if (!pictures.empty()) section.parts.emplace_back(report::Gallery{std::move(pictures)});
  section.parts.emplace_back(recommendations_table(data));
  section.parts.emplace_back(commands_table(data));
  section.parts.emplace_back(wishes_table(data));
  return section;
}

class Advise : public RowsOf<AdviceRow> {
 public:
  void add_options(session::OptionList& command) override {
    options_.add_to(command);
    asked_ = &command;
  }

  [[nodiscard]] std::vector<std::filesystem::path> inputs() const override { return options_.model.inputs(); }
  /// What was measured serves other wishes and other ranges too.
  [[nodiscard]] std::set<std::string> varied() const override {
    const std::vector<std::string> own = own_options();
    std::set<std::string> names(own.begin(), own.end());
    names.erase("machine");
    names.erase("set");
    return names;
  }
  [[nodiscard]] std::string table_model() const override { return options_.model.model; }
  [[nodiscard]] bool is_of_one_machine() const override { return true; }

  std::vector<Asked> ask() override {
    question_ = question_of(options_);
    std::vector<Asked> asked;
    for (const AdvicePoint& point : question_.points) asked.push_back({to_line(point), question_.job.inputs});
    return asked;
  }

  /// Points that draw the same picture together.
  void measure(std::span<const std::size_t> points, unsigned threads, const Finished& finished) override {
    std::vector<AdvicePoint> missing;
    std::map<AdvicePoint, std::size_t> numbers;
    for (const std::size_t point : points) {
      missing.push_back(question_.points[point]);
      numbers.emplace(missing.back(), point);
    }
    measure_advice(question_.job, missing, threads,
                   [&](const AdviceRow& row) { finished(numbers.at(row.point), to_line(row)); });
  }

  void print() const override {
    const view::Sampling& sampling = question_.job.sampling;
    print_question(fmt::format("{}, {} x {} pixels, on {}", options_.model.model, sampling.width, sampling.height,
                               options_.model.machine),
                   rows(), question_.wishes);
    studies::print_front(rows(), question_.wishes);
    print_advice(advice_, question_.wishes);
  }

  [[nodiscard]] std::string json(const std::string& title) const override {
    return advice_json(title, question_.wishes, rows(), advice_);
  }

  [[nodiscard]] std::vector<plots::Plot> plots() const override {
    return {plot_of_advice(rows(), question_.wishes, advice_.recommendations, plot_stem(options_.model.model))};
  }

  [[nodiscard]] std::string page_title() const override { return "The cheapest memory"; }
  [[nodiscard]] PageSubject page_subject() const override {
    return {options_.model, {machine_of(options_.model)}, false};
  }

  /// Without the points that were searched, which are thousands.
  [[nodiscard]] report::Json page_data(report::Json file) const override {
    file.erase("points");
    return file;
  }

  [[nodiscard]] std::vector<report::Section> sections(const report::Json& data) const override {
    const auto refused = std::ranges::count_if(rows(), [](const AdviceRow& row) { return !row.compiled(); });
    return {recommendations(data, rows().size(), static_cast<std::uint64_t>(refused), pictures_of(options_, advice_)),
            {"Front",
             {report::points_table(data, "/front", "Choices that no other beats, fewest memory bits first",
                                   advise_columns)}}};
  }

  void refuse() const override {
    if (std::ranges::any_of(rows(), [](const AdviceRow& row) { return row.unexplained > 0; }))
      throw InputError("a picture is wrong beyond the bounds of docs/numbers.md; " + whose_fault(are_read()));
    if (advice_.nearest)
      throw InputError("no choice meets all wishes; the nearest has " +
                       misses_text(*advice_.nearest, question_.wishes));
  }

 protected:
  void conclude() override {
    if (std::ranges::none_of(rows(), &AdviceRow::compiled)) throw InputError(rows().front().reason);
    advice_ = advice_of(options_, *asked_, question_, rows(), are_read());
  }

 private:
  AdviseOptions options_;
  const session::OptionList* asked_ = nullptr;
  AdviceQuestion question_;
  studies::Advice advice_;
};

}  // namespace

extern const StudyRow advise_row{
    .name = "advise",
    .does = "Find the cheapest memory for a model: what meets wishes for bits, wrong pixels, speed and colours",
    .example =
        "  csgsim advise carburettor.csg --camera 220,-255,135,2,0,5 --max-bits 64 --max-wrong-pixels 10 --min-fps 20\n"
        "  csgsim advise carburettor.csg --alu-bits 1,2,4,8 --min-colour-bits 12 -o carburettor-advice\n"
        "Lists are with commas, ranges of numbers as 3..8; every combination is measured. What has been measured is "
        "kept in\n"
        "advise.csv at once; the same command goes on after an interruption, and with other wishes measures nothing "
        "anew.",
    .plots = "a plot (.png, .svg) of what memory buys",
    .folder = Folder::optional,
    .has_shards = false,
    .is_quick = true,
    .make = [] { return std::unique_ptr<Study>(std::make_unique<Advise>()); }};

}  // namespace csgsim::studies
