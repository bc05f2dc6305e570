#include <algorithm>
#include <ostream>

#include "cli/command_line.h"
#include "cli/report.h"

/// Commands that list what this installation has: formats and plugins; and help by name.
namespace blossom {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> flagsOf(const std::string& id, const std::vector<ParameterSpec>& specs) {
  std::vector<std::string> flags;
  flags.reserve(specs.size());
  for (const ParameterSpec& spec : specs) flags.push_back("--" + id + "." + spec.name);
  return flags;
}

int listFormats(const Invocation& invocation) {
  Value all = Value::array();
  std::vector<std::vector<std::string>> lines{{".blossom", "reads", "writes", "Blossom document", ""}};
  for (const Format& format : invocation.app.formats->formats()) {
    const auto options = [&](const std::vector<ParameterSpec>& specs) { return flagsOf(format.id, specs); };
    all.push_back({{"id", format.id},
                   {"title", format.title},
                   {"extensions", format.extensions},
                   {"reads", static_cast<bool>(format.read)},
                   {"writes", static_cast<bool>(format.write)},
                   {"read_options", options(format.readOptions)},
                   {"write_options", options(format.writeOptions)}});
    auto flags = options(format.writeOptions);
    for (const auto& flag : options(format.readOptions))
      if (std::find(flags.begin(), flags.end(), flag) == flags.end()) flags.push_back(flag);
    lines.push_back({"." + joined(format.extensions, " ."), format.read ? "reads" : "", format.write ? "writes" : "",
                     format.title, joined(flags, " ")});
  }
  if (invocation.json)
    printJson(invocation.terminal.out, {{"formats", all}});
  else
    printTable(invocation.terminal.out, {"EXTENSIONS", "READS", "WRITES", "FORMAT", "OPTIONS"}, lines);
  return 0;
}

int listPlugins(const Invocation& invocation) {
  Value all = Value::array();
  std::vector<std::vector<std::string>> lines;
  for (const LoadedPlugin& plugin : invocation.app.plugins) {
    const PluginManifest& manifest = plugin.manifest;
    all.push_back({{"id", manifest.id},
                   {"title", manifest.title},
                   {"version", manifest.version},
                   {"summary", manifest.summary},
                   {"features", manifest.features},
                   {"formats", manifest.formats},
                   {"folder", manifest.folder.string()},
                   {"loaded", plugin.problem.empty()},
                   {"problem", plugin.problem}});
    lines.push_back({manifest.id, manifest.version, plugin.problem.empty() ? "loaded" : "skipped",
                     plugin.problem.empty() ? manifest.summary : plugin.problem, manifest.folder.string()});
  }
  if (invocation.json)
    printJson(invocation.terminal.out, {{"plugins", all}});
  else
    printTable(invocation.terminal.out, {"PLUGIN", "VERSION", "STATE", "SUMMARY", "FOLDER"}, lines);
  return 0;
}

struct HelpCommand {
  HelpCommand(CommandLine& line, Invocation& invocation) {
    CLI::App& app = line.add("help", "Print the help of a command.", invocation, [this, &line, &invocation] {
      if (name.empty()) {
        invocation.terminal.out << line.root.help();
        return 0;
      }
      const CLI::App* command = line.find(name);
      if (!command) {
        const std::string near = nearestName(name, line.commandNames());
        throw UsageError("There is no command \"" + name + "\".",
                         near.empty() ? "\"blossom --help\" lists the commands." : "Did you mean " + near + "?",
                         ErrorCode::NotFound);
      }
      invocation.terminal.out << command->help("blossom", CLI::AppFormatMode::Normal);
      return 0;
    });
    app.add_option("COMMAND", name, "A command, or the id of a feature.")->type_name("");
    setExamples(app, {"blossom help convert"});
  }
  std::string name;
};

}  // namespace

void addFormatsCommand(CommandLine& line, Invocation& invocation) {
  setExamples(line.add("formats", "List the file formats with their options.", invocation,
                       [&invocation] { return listFormats(invocation); }),
              {"blossom formats"});
}

void addPluginsCommand(CommandLine& line, Invocation& invocation) {
  setExamples(line.add("plugins", "List the plugins, also those that could not be loaded.", invocation,
                       [&invocation] { return listPlugins(invocation); }),
              {"blossom plugins"});
}

void addHelpCommand(CommandLine& line, Invocation& invocation) {
  line.keep(std::make_shared<HelpCommand>(line, invocation));
}

}  // namespace blossom
