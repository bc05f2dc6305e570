#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/session.h"

namespace blossom {

/// A subcommand and its action; `run` returns the exit code and may throw Error.
struct Command {
  CLI::App* app;
  std::function<int()> run;
};

/// The grammar of the command line and its commands; completion scripts are generated from the same object.
struct CommandLine {
  CommandLine();

  /// Adds a subcommand with the common flags (--json, --progress, --threads).
  CLI::App& add(const std::string& name, const std::string& summary, Session&, std::function<int()> run);
  /// Adds the flags of commands that open documents (--salvage, --allow-files).
  static void addDocumentFlags(CLI::App&, Session&);
  /// Keeps an object alive as long as the grammar, because the flags of a command write into it.
  void keep(std::shared_ptr<void> owner) { owners.push_back(std::move(owner)); }
  [[nodiscard]] bool has(const std::string& name) const;
  /// Finds a command by name or by the id of its feature type; nullptr when there is none.
  [[nodiscard]] const CLI::App* find(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> commandNames() const;

  CLI::App root;
  std::vector<Command> commands;
  std::vector<std::shared_ptr<void>> owners;
  std::map<const CLI::Option*, std::vector<std::string>> choices;  ///< of options whose value is one of a few words
};

/// Sets the examples at the end of the `--help` of a command.
void setExamples(CLI::App&, const std::vector<std::string>& lines);

// One file each. Built-in commands are added first; a feature type with the name of a built-in command is reached by its id.
void addConvertCommand(CommandLine&, Session&);
void addInfoCommand(CommandLine&, Session&);
void addRenderCommand(CommandLine&, Session&);
void addRunCommand(CommandLine&, Session&);
void addFeaturesCommand(CommandLine&, Session&);
void addFormatsCommand(CommandLine&, Session&);
void addPluginsCommand(CommandLine&, Session&);
void addCompletionCommand(CommandLine&, Session&);
void addHelpCommand(CommandLine&, Session&);
void addFeatureCommands(CommandLine&, Session&);

}  // namespace blossom
