#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/invocation.h"

namespace blossom {

/// One subcommand and what it does; `run` returns the exit code and may throw Error.
struct Subcommand {
  CLI::App* app;
  std::function<int()> run;
};

/// The grammar of the command line and its commands; completion scripts are generated from the same object.
struct CommandLine {
  CommandLine();

  /// A subcommand with the flags that all have (--json, --progress, --threads).
  CLI::App& add(const std::string& name, const std::string& summary, Invocation&, std::function<int()> run);
  /// The flags of the commands that open documents (--salvage, --allow-files).
  static void addDocumentFlags(CLI::App&, Invocation&);
  /// Keeps what the flags of a command write into alive as long as the grammar.
  void keep(std::shared_ptr<void> owner) { owners.push_back(std::move(owner)); }
  [[nodiscard]] bool has(const std::string& name) const;
  /// Finds a command by name or by the id of its feature type; nullptr when there is none.
  [[nodiscard]] const CLI::App* find(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> commandNames() const;

  CLI::App root;
  std::vector<Subcommand> commands;
  std::vector<std::shared_ptr<void>> owners;
  std::map<const CLI::Option*, std::vector<std::string>> choices;  ///< of options whose value is one of a few words
};

/// Sets the examples at the end of the `--help` of a command.
void setExamples(CLI::App&, const std::vector<std::string>& lines);

// One file each. Built-in commands come first: a feature type of the same command name is then reached by its id alone.
void addConvertCommand(CommandLine&, Invocation&);
void addInfoCommand(CommandLine&, Invocation&);
void addRenderCommand(CommandLine&, Invocation&);
void addRunCommand(CommandLine&, Invocation&);
void addFeaturesCommand(CommandLine&, Invocation&);
void addFormatsCommand(CommandLine&, Invocation&);
void addPluginsCommand(CommandLine&, Invocation&);
void addCompletionCommand(CommandLine&, Invocation&);
void addHelpCommand(CommandLine&, Invocation&);
void addFeatureCommands(CommandLine&, Invocation&);

}  // namespace blossom
