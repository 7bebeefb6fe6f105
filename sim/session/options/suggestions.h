// Suggestions for unknown options and keys.
// Used by sim/session and sim/shell.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::session {

/// What a user probably meant by an unknown option, with its dashes: a form such as `--orbit`, or `--set
/// alu.bits=VALUE` if the option is a key that --set takes. Empty if nothing is similar. `known` are the options of the
/// request.
std::string suggested_option(std::string_view word, std::span<const std::string> known);

/// The keys of --set nearest to an unknown key, at most three: those that contain it as one of their parts, or else the
/// most similar ones. For an effect, its switch alone. Empty if none is similar.
std::vector<std::string> suggested_keys(std::string_view key);

/// Whether the word, without dashes, is the name of an option of any command.
bool is_option_name(std::string_view word);

/// The words as a list: `a`, `a or b`, `a, b or c`.
std::string alternatives_text(std::span<const std::string> words);

}  // namespace csgsim::session
