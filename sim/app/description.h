#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace csgsim::app {

/// What stands behind an option, or in an operand's place.
enum class ValueKind : std::uint8_t {
  none,      ///< nothing: a flag
  words,     ///< one of `words`
  file,      ///< a file or folder
  machines,  ///< a machine's name, which `words` has, or its file
  text,      ///< any other text, or a number
};

/// An option or operand as the command line has it.
struct DescribedOption {
  std::string name;                ///< the long one without dashes, or an operand's: `MODEL`
  std::vector<std::string> names;  ///< with dashes, as they are typed; none of an operand
  std::string type;                ///< `TEXT`, `UINT`, `FLOAT`; empty of a flag
  std::string meaning;
  std::string usual;  ///< the value if nothing is said; may be empty
  std::string range;  ///< of a number; may be empty
  ValueKind kind = ValueKind::none;
  std::vector<std::string> words;
  bool is_required = false;
  bool takes_several = false;
};

struct DescribedCommand {
  std::string name;
  std::string meaning;
  std::string footer;  ///< its example
  std::vector<DescribedOption> operands;
  std::vector<DescribedOption> options;
};

/// The whole command line, without what help hides.
struct Description {
  std::string program;
  std::string meaning;
  std::string version;
  std::string date;  ///< of the sources, as in 2001-12-31
  std::vector<DescribedOption> options;
  std::vector<DescribedCommand> commands;
};

/// A file that is made from the description.
struct DescriptionFile {
  std::string name;
  std::string content;
};

/// `NAME.1` and `NAME-COMMAND.1`, pages for man.
std::vector<DescriptionFile> manual_pages(const Description& description);

/// Completion for the shells, and the description itself.
std::string bash_completion(const Description& description);
std::string zsh_completion(const Description& description);
std::string fish_completion(const Description& description);
std::string description_json(const Description& description);

/// Writes all of them to the folder, which is made if it is not there. Throws InputError.
void write_description(const Description& description, const std::string& folder);

}  // namespace csgsim::app
