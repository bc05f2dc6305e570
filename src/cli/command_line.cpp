#include "cli/command_line.h"

#include <algorithm>
#include <sstream>

#include "core/version.h"

namespace blossom {
namespace {

/// "stl.ascii" -> "stl." and "ascii"
std::string withoutLast(const std::string& name) { return name.substr(0, name.rfind('.') + 1); }
std::string lastWord(const std::string& name) { return name.substr(name.rfind('.') + 1); }

constexpr std::size_t helpColumn = 34, widestHelp = 110;

/// Wraps long help below its beginning; lines of another form are unchanged.
std::string wrapped(std::string line) {
  if (line.size() <= helpColumn || line.substr(0, 2) != "  " || line[helpColumn - 1] != ' ') return line;
  std::string text;
  while (line.size() > widestHelp) {
    const std::size_t space = line.rfind(' ', widestHelp);
    if (space == std::string::npos || space <= helpColumn) break;
    text += line.substr(0, space) + '\n';
    line = std::string(helpColumn, ' ') + line.substr(space + 1);
  }
  return text + line;
}

/// CLI11 repeats "TEXT" for every option and joins help in one long line; this keeps two calm columns.
class HelpFormatter final : public CLI::Formatter {
 public:
  HelpFormatter() {
    column_width(helpColumn);
    label("OPTIONS", "flags");
    label("SUBCOMMAND", "COMMAND");
  }
  /// "--[no-]solid" instead of "--solid,--no-solid{false}"
  std::string make_option_name(const CLI::Option* option, bool positional) const override {
    const auto& names = option->get_lnames();
    if (!positional && names.size() == 2 && option->get_items_expected_max() == 0) {
      const std::string no = withoutLast(names[0]) + "no-" + lastWord(names[0]);
      if (names[1] == no) return "--" + withoutLast(names[0]) + "[no-]" + lastWord(names[0]);
    }
    return CLI::Formatter::make_option_name(option, positional);
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_size() == 0 || option->get_type_name().empty() ? "" : " " + option->get_type_name();
  }
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::istringstream lines(CLI::Formatter::make_help(app, std::move(name), mode));
    std::string text, line;
    for (bool wasEmpty = false; std::getline(lines, line); wasEmpty = line.empty())
      if (!line.empty() || !wasEmpty) text += wrapped(line) + '\n';
    return text;
  }
  std::string make_usage(const CLI::App* app, std::string name) const override {
    return "Usage: " + CLI::Formatter::make_usage(app, std::move(name)).erase(0, std::string("Usage: ").size());
  }
};

}  // namespace

CommandLine::CommandLine()
    : root("Blossom makes shapes that morph, sweep, grow and melt, and reads and writes the formats of the trade.",
           "blossom") {
  root.formatter(std::make_shared<HelpFormatter>());
  root.set_help_flag("-h,--help", "Print this help.");
  root.set_version_flag("--version", std::string("blossom ") + versionText, "Print the version.");
  root.require_subcommand(0, 1);
  root.allow_extras();  // reported by runCli, with the nearest name
  setExamples(
      root, {"blossom sweep propeller.json --solid -o propeller.step", "blossom convert part.step part.stl --stl.chord 0.01",
             "blossom info part.step --json", "blossom help sweep"});
}

CLI::App& CommandLine::add(const std::string& name, const std::string& summary, Invocation& invocation,
                           std::function<int()> run) {
  CLI::App& command = *root.add_subcommand(name, summary);
  command.allow_extras();
  command.add_flag("--json", invocation.json, "Print exactly one JSON object on standard output.");
  command.add_flag("--progress", invocation.progressLines, "Print progress as plain lines on standard error.");
  command.add_option("--threads", invocation.threads, "Most threads to use; 0: as many as the machine has.")
      ->type_name("COUNT")
      ->check(CLI::Range(0, 4096).description(""));
  commands.push_back({&command, std::move(run)});
  return command;
}

void CommandLine::addDocumentFlags(CLI::App& command, Invocation& invocation) {
  command.add_flag("--salvage", invocation.salvage, "Open what is readable of a damaged document; the rest is a warning.");
  command.add_flag("--allow-files", invocation.allowFiles,
                   "Let documents read the files that they name outside of their own folder.");
}

const CLI::App* CommandLine::find(const std::string& name) const {
  const auto found =
      std::find_if(commands.begin(), commands.end(), [&](const Subcommand& each) { return each.app->check_name(name); });
  return found == commands.end() ? nullptr : found->app;
}

bool CommandLine::has(const std::string& name) const { return find(name) != nullptr; }

std::vector<std::string> CommandLine::commandNames() const {
  std::vector<std::string> names;
  for (const Subcommand& each : commands) names.push_back(each.app->get_name());
  return names;
}

void setExamples(CLI::App& app, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::string footer = lines.size() == 1 ? "Example:" : "Examples:";
  for (const std::string& line : lines) footer += "\n  " + line;
  app.footer(footer);
}

}  // namespace blossom
