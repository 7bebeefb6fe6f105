#include "sim/rows/trace.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>

#include "hw/base/error.h"
#include "hw/bit_serial_memory/kind.h"
#include "hw/bit_serial_memory/timing_rows.h"

namespace csgsim::rows {

namespace {

/// Writes the lines of each instruction in the order of their clocks: all banks are closed between instructions.
class Recorder final : public bit_serial_memory::RowListener {
 public:
  Recorder(Form& form, const std::function<void(std::string_view)>& write) : form_(form), write_(write) {
    append(form_.heading());
  }

  void begin_segment(std::uint32_t segment) override { begin(form_.segment(segment)); }
  void begin_instruction(std::uint64_t number, const isa::Instruction& instruction) override {
    begin(form_.instruction(number, instruction));
  }
  void begin_scan_out() override { begin(form_.scan_out()); }
  void refresh(std::uint64_t clock) override {
    ++refreshes_;
    form_.add_refresh(clock, lines_);
  }

  void command(const RowCommand& command, std::span<const Issue> issues) override {
    ++commands_[static_cast<std::size_t>(command.op)];
    for (const auto* raised : {&command.from, &command.to}) further_rows_ += raised->count > 1 ? raised->count - 1U : 0;
    masks_ += command.masked ? 1 : 0;
    for (const Issue& issue : issues) form_.add(command, issue, lines_);
  }

  TraceSummary finish(const machines::FrameTiming& timing) {
    begin(form_.end(timing));
    if (!text_.empty()) write_(text_);
    TraceSummary summary{.lines = written_, .timing = timing, .replacements = replacements()};
    for (const std::uint64_t count : commands_) summary.commands += count;
    return summary;
  }

 private:
  static constexpr std::size_t chunk = std::size_t{1} << 20U;  ///< bytes of a call of write_

  /// Ends the lines of the previous instruction and begins the next with `heading`.
  void begin(const std::string& heading) {
    std::ranges::stable_sort(lines_, {}, &Line::clock);
    for (const Line& line : lines_) append(line.text);
    lines_.clear();
    append(heading);
  }

  void append(const std::string& text) {
    written_ += static_cast<std::uint64_t>(std::ranges::count(text, '\n'));
    text_ += text;
    if (text_.size() < chunk) return;
    write_(text_);
    text_.clear();
  }

  [[nodiscard]] std::vector<Replacement> replacements() const {
    std::vector<Replacement> all;
    const auto add = [&](std::string_view what, std::string_view instead, std::uint64_t count) {
      if (count > 0) all.push_back({std::string(what), std::string(instead), count});
    };
    for (std::size_t op = 0; op < commands_.size(); ++op) {
      const std::string_view instead = form_.instead(static_cast<RowOp>(op));
      if (!instead.empty()) add(bit_serial_memory::row_op_names.at(op), instead, commands_.at(op));
    }
    if (!form_.has_all_rows()) {
      add("second and third rows activated together", "nothing", further_rows_);
      add("masks of writes", "nothing", masks_);
    }
    if (!form_.has_refreshes()) add("refreshes", "nothing", refreshes_);
    return all;
  }

  Form& form_;
  const std::function<void(std::string_view)>& write_;
  Lines lines_;
  std::string text_;
  std::uint64_t written_ = 0;  ///< number of lines
  std::array<std::uint64_t, bit_serial_memory::row_op_count> commands_{};
  std::uint64_t further_rows_ = 0;
  std::uint64_t masks_ = 0;
  std::uint64_t refreshes_ = 0;
};

}  // namespace

TraceSummary write_trace(const isa::Program& program, const machines::Machine& machine,
                         const machines::RunOutcome& outcomes, const FormRow& form_row,
                         const std::function<void(std::string_view)>& write,
                         const bit_serial_memory::CommandSet* command_set) {
  if (machine.kind != &bit_serial_memory::kind) {
    throw InputError(machine.name +
                     " has no row commands; choose a machine of kind bit-serial-memory, such as simdram-ddr4");
  }
  machines::Machine drawing = machine;
  machines::set_picture_size(drawing, {program.shape.width, program.shape.height});
  const Frame frame{.program = program,
                    .machine = drawing,
                    .figures = machines::kind_figures<bit_serial_memory::Figures>(drawing),
                    .map = {drawing.array.memory_bits, program.shape.width, program.shape.height},
                    .slots = bit_serial_memory::slots_of(drawing),
                    .set = command_set};
  if (command_set != nullptr && frame.figures.design != bit_serial_memory::Design::latches) {
    throw InputError(drawing.name +
                     " has no gates that a command set could replace; choose a machine whose logic.design is latches, "
                     "such as digital-bit-serial-ddr4");
  }
  const std::unique_ptr<Form> form = form_row.make(frame);
  Recorder recorder(*form, write);
  return recorder.finish(bit_serial_memory::time_rows(program, drawing, outcomes, recorder, command_set));
}

}  // namespace csgsim::rows
