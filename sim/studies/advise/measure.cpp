#include "sim/studies/advise/measure.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/machines/regions.h"
#include "sim/judges/errors.h"
#include "sim/judges/explain.h"
#include "sim/judges/truth.h"
#include "sim/observe/frame.h"
#include "sim/studies/fitted_program.h"
#include "sim/studies/measured_row.h"
#include "sim/studies/parallel.h"

namespace csgsim::studies {

namespace {

view::View view_of(const AdviceJob& job, const AdvicePoint& point) {
  view::Sampling sampling = job.sampling;
  sampling.z_bits = point.z_bits;
  sampling.fraction_bits = point.fraction_bits;
  return view::make_view(job.subject->scene, job.subject->tree, job.camera, sampling);
}

template <class Choices>
auto named(const Choices& choices, std::string_view name) {
  const auto found =
      std::find_if(choices.begin(), choices.end(), [&](auto choice) { return emit::name_of(choice) == name; });
  if (found == choices.end()) throw std::invalid_argument("there is no " + std::string(name));
  return *found;
}

emit::Options options_of(const AdviceJob& job, const AdvicePoint& point) {
  emit::Options options = job.options;
  options.strategy = named(emit::strategies, point.strategy);
  options.stack_bits = std::max(point.stack_bits, emit::fewest_stack_bits);
  options.colouring = named(emit::colourings, point.colouring);
  options.colour_bits = point.colour_bits;
  return options;
}

/// Where a kind has no such figure, there is one machine.
const machines::Machine& machine_of(const AdviceJob& job, const AdvicePoint& point) {
  for (const machines::Machine& machine : job.machines) {
    if (point.alu_bits == 0 || machine.alu_bits == point.alu_bits) return machine;
  }
  throw std::invalid_argument("there is no machine with such an ALU");
}

Fitted compile(const AdviceJob& job, const view::View& view, const AdvicePoint& point, std::uint32_t guess) {
  machines::Machine machine = machine_of(job, point);
  const std::uint32_t most = std::max(machine.array.memory_bits, most_advice_bits);
  return compile_fitting(job.subject->tree, job.subject->scene, view, std::move(machine), options_of(job, point),
                         {guess, most});
}

/// The greatest difference of a channel.
unsigned colour_error(const observe::Frame& exact, const observe::Frame& frame, unsigned bits) {
  int most = 0;
  for (std::size_t i = 0; i < frame.colour.size(); ++i) {
    const auto of_exact = isa::unpack_colour(exact.colour[i], isa::most_colour_bits);
    const auto of_frame = isa::unpack_colour(frame.colour[i], bits);
    for (std::size_t channel = 0; channel < of_exact.size(); ++channel)
      most = std::max(most, std::abs(int{of_exact[channel]} - int{of_frame[channel]}));
  }
  return static_cast<unsigned>(most);
}

/// How right a picture is.
struct Verdict {
  std::uint64_t wrong = 0;
  std::uint64_t unexplained = 0;
  unsigned colour_error = 0;
};

/// Judges the pictures with some z bits and fraction bits.
class Judge {
 public:
  Judge(const AdviceJob& job, const judges::Truth& truth, const view::View& view)
      : job_(job), truth_(truth), view_(view) {}

  /// Of the point's picture. Points that differ in colour bits alone may follow.
  Verdict verdict(AdvicePoint point) {
    const unsigned colour_bits = std::exchange(point.colour_bits, isa::most_colour_bits);
    if (!finest_) {
      finest_ = draw(point);
      of_finest_ = judge(*finest_);
    }
    if (colour_bits == isa::most_colour_bits) return of_finest_;
    point.colour_bits = colour_bits;
    const Drawn drawn = draw(point);
    const bool is_alike = drawn.frame.depth == finest_->frame.depth && drawn.frame.owner == finest_->frame.owner;
    Verdict verdict = is_alike ? of_finest_ : judge(drawn);
    verdict.colour_error = colour_error(finest_->frame, drawn.frame, colour_bits);
    return verdict;
  }

 private:
  struct Drawn {
    isa::Program program;
    observe::Frame frame;
  };

  [[nodiscard]] Drawn draw(const AdvicePoint& point) const {
    Fitted fitted = compile(job_, view_, point, 0);
    observe::FrameObserver frame(fitted.program);
    const std::array<engine::Observer*, 1> observers{&frame};
    const engine::RunResult result = engine::make_functional_engine(fitted.machine)->run(fitted.program, observers);
    if (result.overflows > 0) throw InputError("a linear expression does not fit its width; this is a fault of csgsim");
    return {std::move(fitted.program), std::move(frame).frame()};
  }

  [[nodiscard]] Verdict judge(const Drawn& drawn) const {
    const judges::Explainer explainer(job_.subject->tree, job_.subject->scene, job_.camera, drawn.program);
    const judges::Errors errors = judges::judge(truth_, drawn.frame, drawn.program, explainer);
    return {errors.wrong(), errors.unexplained, 0};
  }

  const AdviceJob& job_;
  const judges::Truth& truth_;
  const view::View& view_;
  std::optional<Drawn> finest_;
  Verdict of_finest_;
};

judges::Truth truth_of(const AdviceJob& job, const AdvicePoint& any) {
  return judges::exact_truth(job.subject->tree, job.subject->scene, job.camera, job.sampling.width, job.sampling.height,
                             view_of(job, any).depth);
}

/// Points with the same z bits and fraction bits, one after the other.
class Family {
 public:
  Family(const AdviceJob& job, const judges::Truth& truth, const AdvicePoint& any)
      : job_(job), view_(view_of(job, any)), judge_(job, truth, view_) {}
  Family(const Family&) = delete;
  Family& operator=(const Family&) = delete;

  AdviceRow measure(const AdvicePoint& point) {
    return measured_row<AdviceRow>(point, job_.inputs, [&](AdviceRow& row) {
      const Fitted fitted = compile(job_, view_, point, guess(point));
      found_[key(point)] = {point.colour_bits, fitted.machine.array.memory_bits};
      judge(row);
      count(fitted, row);
    });
  }

 private:
  /// Strategies, colourings and ALU widths draw the same picture: the first that compiles is judged for all.
  void judge(AdviceRow& row) {
    auto known = verdicts_.find(row.point.colour_bits);
    if (known == verdicts_.end()) known = verdicts_.emplace(row.point.colour_bits, judge_.verdict(row.point)).first;
    row.wrong = known->second.wrong;
    row.unexplained = known->second.unexplained;
    row.colour_error = known->second.colour_error;
  }

  void count(const Fitted& fitted, AdviceRow& row) {
    const machines::FrameTiming timing = timer_.time(fitted.program, fitted.machine);
    row.used_bits = fitted.machine.array.memory_bits;
    row.classification_bits = fitted.program.facts->compile.stack_bits;
    row.clocks = timing.clocks;
    row.interval_clocks = timing.interval_clocks;
    row.frames_per_second = static_cast<double>(fitted.machine.clock_hz) / static_cast<double>(timing.interval_clocks);
  }

  using Key = std::tuple<std::string, unsigned, std::string>;
  static Key key(const AdvicePoint& point) { return {point.strategy, point.stack_bits, point.colouring}; }

  /// How many bits the point will take, from one that has other colours; 0 if none is known.
  [[nodiscard]] std::uint32_t guess(const AdvicePoint& point) const {
    const auto found = found_.find(key(point));
    if (found == found_.end()) return 0;
    const auto& [colour_bits, bits] = found->second;
    const machines::Machine& machine = machine_of(job_, point);
    const auto in_all = [&](unsigned of_one) {
      const bool is_twice = point.colouring == emit::name_of(emit::Colouring::field);
      return of_one * (is_twice ? 2U : 1U) + machines::second_buffer(of_one, machine).width;
    };
    return bits + in_all(point.colour_bits) - in_all(colour_bits);
  }

  const AdviceJob& job_;
  view::View view_;
  Judge judge_;
  std::map<unsigned, Verdict> verdicts_;                     ///< by colour bits
  std::map<Key, std::pair<unsigned, std::uint32_t>> found_;  ///< colour bits, and bits in all
  RunTimer timer_;
};

/// Neighbours with the same z bits and fraction bits.
std::vector<std::span<const AdvicePoint>> families_of(std::span<const AdvicePoint> points) {
  std::vector<std::span<const AdvicePoint>> families;
  for (std::size_t begin = 0; begin < points.size();) {
    std::size_t end = begin + 1;
    while (end < points.size() && points[end].z_bits == points[begin].z_bits &&
           points[end].fraction_bits == points[begin].fraction_bits)
      ++end;
    families.push_back(points.subspan(begin, end - begin));
    begin = end;
  }
  return families;
}

}  // namespace

void measure_advice(const AdviceJob& job, std::span<const AdvicePoint> points, unsigned threads,
                    const std::function<void(AdviceRow)>& finished) {
  if (points.empty()) return;
  const judges::Truth truth = truth_of(job, points.front());
  const std::vector<std::span<const AdvicePoint>> families = families_of(points);
  share_out(families.size(), threads, [&](std::size_t i, const auto& finish) {
    Family family(job, truth, families[i].front());
    for (const AdvicePoint& point : families[i]) {
      AdviceRow row = family.measure(point);
      if (!finish([&] { finished(std::move(row)); })) return;
    }
  });
}

AdviceRow draw_advice(const AdviceJob& job, const AdvicePoint& point) {
  const judges::Truth truth = truth_of(job, point);
  return Family(job, truth, point).measure(point);
}

}  // namespace csgsim::studies
