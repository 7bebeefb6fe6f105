#include "sim/shell/settings/settings_app.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "sim/shell/command_line.h"
#include "sim/shell/usage.h"

namespace csgsim::shell {

namespace {

constexpr std::string_view config_name = "--config";
constexpr std::string_view dump_name = "--dump-config";
const std::string dump_meaning = "Print every option as it is now, as a settings file, and do nothing";
constexpr InputKind settings_input{"name a settings file, .toml", std::size_t{1} << 20U,
                                   "a command has far fewer options"};

/// Has its state for as long as one command line is looked at; the commands below are plain ones.
class SettingsApp : public CLI::App {
 public:
  using CLI::App::App;

  std::vector<std::string> arguments;
  std::vector<Setting> settings;      ///< of the command that is asked for
  std::vector<Setting> taken;         ///< of these, what the command line does not say
  std::vector<CLI::Option*> excused;  ///< options that have to be given, and are by the settings
  bool is_of_data = false;            ///< the settings are of no file that the command line names
  bool is_only_read = false;          ///< no command is run
  RunWatch watch;

 private:
  /// The command line has been read, and no command run.
  void pre_callback() override;
  void take_settings(CLI::App& command);
};

SettingsApp& settings_app(CLI::App& app) { return dynamic_cast<SettingsApp&>(app); }
const SettingsApp& settings_app(const CLI::App& app) { return dynamic_cast<const SettingsApp&>(app); }

/// Does it with the option, and tells the place of what is wrong.
template <class Do>
void at_place_of(const Setting& setting, const Do& what) {
  try {
    what();
  } catch (const CLI::ParseError& error) {
    throw InputError(setting.place + ": " + error.what());
  } catch (const UsageError& error) {
    throw InputError(setting.place + ": " + error.what());
  }
}

void put(CLI::Option& option, const std::vector<std::string>& values) {
  option.clear();
  for (const std::string& value : values) option.add_result(value);
}

void give(CLI::Option& option, const Setting& setting) {
  put(option, setting.values);
  at_place_of(setting, [&] { option.run_callback(); });
}

bool is_overridden(const CLI::Option& option) {
  const std::set<CLI::Option*> others = option.get_excludes();
  return option.count() > 0 || std::ranges::any_of(others, [](const CLI::Option* one) { return one->count() > 0; });
}

/// What the command line says stays, but what the settings say has to be right all the same.
void check_overridden(CLI::Option& option, const Setting& setting) {
  const std::vector<std::string> said = option.results();
  put(option, setting.values);
  at_place_of(setting, [&] { static_cast<void>(option.reduced_results()); });
  put(option, said);
}

CLI::Option* option_named(CLI::App& command, std::string_view name) {
  for (CLI::Option* option : command.get_options()) {
    if (settable(*option).name == name) return option;
  }
  return nullptr;
}

std::vector<std::string> values_of(const CLI::Option& option) {
  const bool is_flag = option.get_items_expected_max() == 0;
  if (option.count() == 0 && is_flag) return {"false"};
  if (option.count() > 0 || option.get_default_str().empty()) return option.results();
  return {option.get_default_str()};
}

bool wants_dump(const CLI::App& command) {
  const CLI::Option* const option = command.get_option_no_throw(std::string(dump_name));
  return option != nullptr && option->count() > 0;
}

void SettingsApp::pre_callback() {
  for (CLI::Option* option : excused) option->required();
  excused.clear();
  if (is_only_read) throw CLI::Success();
  if (get_subcommands().empty()) return;
  CLI::App& command = *get_subcommands().front();
  take_settings(command);
  if (!wants_dump(command)) return;
  fmt::print("{}", settings_text(command.get_name(), Command(command).values()));
  throw CLI::Success();
}

void SettingsApp::take_settings(CLI::App& command) {
  std::vector<std::pair<CLI::Option*, const Setting*>> to_give;
  for (const Setting& setting : settings) {
    CLI::Option* const option = option_named(command, setting.name);
    if (is_overridden(*option)) {
      check_overridden(*option, setting);
    } else {
      to_give.emplace_back(option, &setting);
    }
  }
  for (const auto& [option, setting] : to_give) {
    if (option->count() == 0 && is_overridden(*option))
      throw InputError(fmt::format("{}: {} stands in place of another option that is set; leave one out",
                                   setting->place, setting->name));
    give(*option, *setting);
    if (option->get_items_expected_max() == 0 && setting->values.front() == "false") option->clear();
    taken.push_back(*setting);
  }
}

/// Of --config FILE or --config=FILE; empty if it is not there.
std::string named_file(std::span<const std::string> arguments) {
  for (std::size_t i = 0; i < arguments.size() && arguments[i] != "--"; ++i) {
    const std::string& word = arguments[i];
    if (word == config_name && i + 1 < arguments.size()) return arguments[i + 1];
    if (word.starts_with(config_name) && word.substr(config_name.size()).starts_with('='))
      return word.substr(config_name.size() + 1);
  }
  return {};
}

CLI::App* command_named(CLI::App& app, std::string_view name) {
  const std::vector<CLI::App*> commands = app.get_subcommands({});
  const auto found = std::ranges::find_if(commands, [&](const CLI::App* one) { return one->get_name() == name; });
  return found == commands.end() ? nullptr : *found;
}

/// Commands that have options.
std::vector<SettableCommand> commands_of(CLI::App& app) {
  std::vector<SettableCommand> commands;
  for (CLI::App* command : app.get_subcommands({})) {
    SettableCommand one{command->get_name(), settable_options(*command)};
    if (!one.options.empty()) commands.push_back(std::move(one));
  }
  return commands;
}

void add_config_options(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({})) {
    if (settable_options(*command).empty() || command->get_option_no_throw(std::string(config_name)) != nullptr)
      continue;
    command
        ->add_option(std::string(config_name),
                     "A settings file, .toml: options of this command and others; what the command line says wins")
        ->type_name("TEXT");
    command->add_flag(std::string(dump_name), dump_meaning);
  }
}

}  // namespace

std::unique_ptr<CLI::App> make_settings_app(const std::string& description, const std::string& program) {
  return std::make_unique<SettingsApp>(description, program);
}

SettableOption settable(const CLI::Option& option) {
  if (option.get_positional()) {
    std::string name = option.get_name();
    std::ranges::transform(name, name.begin(), [](unsigned char letter) { return std::tolower(letter); });
    return {name, option.get_items_expected_max() > 1 ? Takes::texts : Takes::text};
  }
  if (option.get_lnames().empty()) return {};
  const std::string& name = option.get_lnames().front();
  if (name == "help" || config_name.substr(2) == name || dump_name.substr(2) == name) return {};
  if (option.get_items_expected_max() == 0) return {name, Takes::flag};
  if (option.get_items_expected_max() > 1) return {name, Takes::texts};
  const std::string type = option.get_type_name();
  if (type.starts_with("UINT")) return {name, Takes::whole_number};
  if (type.starts_with("FLOAT")) return {name, Takes::number};
  return {name, Takes::text};
}

std::vector<SettableOption> settable_options(const CLI::App& command) {
  std::vector<SettableOption> options;
  for (const CLI::Option* option : command.get_options()) {
    SettableOption one = settable(*option);
    if (!one.name.empty()) options.push_back(std::move(one));
  }
  return options;
}

namespace {

void begin(SettingsApp& state, std::span<char* const> arguments) {
  state.settings.clear();
  state.taken.clear();
  state.is_of_data = false;
  state.is_only_read = false;
  state.arguments.assign(arguments.begin(), arguments.end());
}

/// What the settings say need not be said on the command line.
void excuse(SettingsApp& state, CLI::App& command) {
  const bool all_excused = std::ranges::find(state.arguments, dump_name) != state.arguments.end();
  for (CLI::Option* option : command.get_options()) {
    const std::string name = settable(*option).name;
    const bool is_set = std::ranges::find(state.settings, name, &Setting::name) != state.settings.end();
    if (!option->get_required() || (!all_excused && !is_set)) continue;
    option->required(false);
    state.excused.push_back(option);
  }
}

}  // namespace

void load_settings(CLI::App& app, std::span<char* const> arguments) {
  SettingsApp& state = settings_app(app);
  begin(state, arguments);
  add_config_options(app);
  if (arguments.size() < 2) return;
  CLI::App* const command = command_named(app, state.arguments[1]);
  const std::string file = named_file(std::span(state.arguments).subspan(2));
  if (command == nullptr) return;
  if (!file.empty())
    state.settings = read_settings(read_file(file, settings_input), file, commands_of(app), command->get_name());
  excuse(state, *command);
}

void load_settings(CLI::App& app, std::span<char* const> arguments, std::vector<Setting> settings) {
  SettingsApp& state = settings_app(app);
  begin(state, arguments);
  state.settings = std::move(settings);
  state.is_of_data = true;
  excuse(state, *command_named(app, state.arguments.at(1)));
}

void only_read(CLI::App& app, std::span<char* const> arguments) {
  SettingsApp& state = settings_app(app);
  begin(state, arguments);
  state.is_only_read = true;
}

std::string place_of(const CLI::App& app, const std::string& message) {
  for (const Setting& setting : settings_app(app).taken) {
    const std::string name = "--" + setting.name;
    if (message.starts_with(name) && message.find_first_of(": ", name.size()) == name.size()) return setting.place;
  }
  return {};
}

std::vector<OptionValue> Command::values() const {
  std::vector<OptionValue> values;
  for (const CLI::Option* option : std::as_const(*command_).get_options()) {
    SettableOption one = settable(*option);
    if (one.name.empty()) continue;
    values.push_back({std::move(one), option->get_positional(), option->get_description(), values_of(*option)});
  }
  return values;
}

std::vector<std::string> Command::arguments() const {
  const SettingsApp& app = settings_app(*std::as_const(*command_).get_parent());
  if (!app.is_of_data) return app.arguments;
  std::vector<std::string> all{app.arguments.front()};
  for (std::string& word : words({})) all.push_back(std::move(word));
  return all;
}

RunWatch& Command::watch() const { return settings_app(*command_->get_parent()).watch; }

}  // namespace csgsim::shell
