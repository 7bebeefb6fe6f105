#include <string>
#include <utility>

#include "hw/base/error.h"
#include "hw/isa/quoting.h"
#include "hw/isa/text.h"
#include "hw/isa/text_grammar.h"

namespace csgsim::isa {

namespace {

template <typename Rule>
struct Action : tao::pegtl::nothing<Rule> {};

CSGSIM_WHEN(word) { reading.text = matched; }
CSGSIM_WHEN(string_body) { reading.text = unescaped(matched); }

CSGSIM_WHEN(field_base) { reading.field = Field{Reading::number<std::uint16_t>(matched), 1}; }
CSGSIM_WHEN(field_width) { reading.field.width = Reading::number<std::uint16_t>(matched); }
CSGSIM_WHEN(field_name) { reading.refer_to_field(reading.text); }

CSGSIM_WHEN(minus_sign) { reading.set_negative(); }
CSGSIM_WHEN(magnitude) { reading.set_magnitude(Reading::number<std::uint64_t>(matched)); }
CSGSIM_WHEN(variable) { reading.set_variable(matched.front()); }
CSGSIM_WHEN(term) { reading.end_term(); }
CSGSIM_WHEN(square_variable) { reading.set_square(matched.front(), matched.back()); }
CSGSIM_WHEN(square_term) { reading.end_square_term(); }
CSGSIM_WHEN(linear_width) { reading.instruction.linear.width = Reading::number<std::uint16_t>(matched); }
CSGSIM_WHEN(linear_shift) { reading.instruction.linear.shift = Reading::number<std::uint16_t>(matched); }

CSGSIM_WHEN(hexadecimal) { reading.instruction.constant = Reading::number<std::uint64_t>(matched, 16); }
CSGSIM_WHEN(decimal) { reading.instruction.constant = Reading::number<std::uint64_t>(matched); }

CSGSIM_WHEN(mnemonic) { reading.begin_instruction(matched); }
CSGSIM_WHEN(purpose) { reading.set_purpose(matched); }
CSGSIM_WHEN(primitive) { reading.instruction.origin.primitive = reading.piece(matched); }
CSGSIM_WHEN(node) { reading.instruction.origin.node = reading.piece(matched); }
CSGSIM_WHEN(effect) { reading.set_effect(matched); }

CSGSIM_WHEN(directive_name) { reading.begin_directive(std::string(matched)); }
CSGSIM_WHEN(key) { reading.key = matched; }
CSGSIM_WHEN(string_value) { reading.value = reading.text; }
CSGSIM_WHEN(bare_value) { reading.value = BareValue{std::string(matched)}; }
CSGSIM_WHEN(list_begin) { reading.value = std::vector<std::string>{}; }
CSGSIM_WHEN(list_item) { std::get<std::vector<std::string>>(reading.value).push_back(reading.text); }
CSGSIM_WHEN(pair) { reading.set_value(); }
CSGSIM_WHEN(new_field_name) { reading.name_field(); }
CSGSIM_WHEN(role) { reading.set_role(matched); }
CSGSIM_WHEN(directive) { reading.end_directive(); }

#undef CSGSIM_WHEN

template <>
struct Action<grammar::instruction> : grammar::Located<Action<grammar::instruction>> {
  template <typename ActionInput>
  static void apply(const ActionInput& in, Reading& reading) {
    Located::apply(in, reading);
    reading.set_instruction_position(in.iterator().line, in.iterator().column);
  }
  static void read(std::string_view /*matched*/, Reading& reading) { reading.end_instruction(); }
};

}  // namespace

Program parse(std::string_view text, std::string_view name) {
  tao::pegtl::memory_input<> in(text.data(), text.size(), std::string(name));
  Reading reading;
  grammar::read<grammar::file, Action, grammar::Control>(in, reading);
  return reading.finish(name);
}

}  // namespace csgsim::isa
