#include "cli/cli.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <ostream>

#include "cli/command_line.h"
#include "core/parallel.h"
#include "core/version.h"
#include "parameter/wording.h"

namespace blossom {
namespace {

enum ExitCode { Done = 0, Failed = 1, WrongUse = 2 };

/// CLI11 takes "--name=" for "--name" and would swallow the next word: the empty value becomes a word of its own. Behind
/// "--", which CLI11 hands to the wrong command, all words are files, also those that begin with a hyphen.
std::vector<std::string> wordsOf(int argc, const char* const* argv) {
  std::vector<std::string> words;
  bool flags = true;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (flags && word == "--") {
      flags = false;
      continue;
    }
    if (!flags && word.starts_with('-')) word.insert(0, "./");
    if (flags && word.size() > 3 && word.starts_with("--") && word.find('=') == word.size() - 1) {
      words.push_back(word.substr(0, word.size() - 1));
      words.emplace_back();
    } else {
      words.push_back(std::move(word));
    }
  }
  return words;
}

bool asksForJson(const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), "--json") != words.end();
}

void printError(const Terminal& terminal, const Error& error, bool json) {
  if (json) {
    printJson(terminal.out, {{"error", toJson(error)}});
    return;
  }
  terminal.err << "blossom: " << error.message() << '\n';
  if (!error.hint().empty()) terminal.err << "  " << error.hint() << '\n';
}

std::vector<std::string> flagsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// The names that go on with a hyphen where the word ends: --tool-diameter and --tool-number for --tool; at most four.
std::vector<std::string> continuing(const std::string& word, const std::vector<std::string>& known) {
  std::vector<std::string> found;
  std::copy_if(known.begin(), known.end(), std::back_inserter(found),
               [&](const std::string& name) { return name.starts_with(word + '-'); });
  found.resize(std::min<std::size_t>(found.size(), 4));
  return found;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& known, const std::string& otherwise) {
  if (const auto names = continuing(word, known); !names.empty())
    return fmt::format("Did you mean {}?", enumerated(names, "or"));
  const std::string near = nearestName(word, known);
  return near.empty() ? otherwise : fmt::format("Did you mean {}?", near);
}

/// What nobody understood: behind a command the first flag if there is one, because what follows an unknown flag is usually
/// its value; in front of one the first word, because all that follows an unknown command is unknown too.
[[noreturn]] void refuseWord(const CommandLine& line, const CLI::App& app, const std::vector<std::string>& extras) {
  const auto isFlag = [](const std::string& word) { return word.size() > 1 && word[0] == '-'; };
  const bool atRoot = &app == &line.root;
  const auto firstFlag = std::find_if(extras.begin(), extras.end(), isFlag);
  const std::string word = atRoot || firstFlag == extras.end() ? extras.front() : *firstFlag;
  const std::string help = atRoot ? "\"blossom --help\" lists the commands."
                                  : fmt::format("\"blossom {} --help\" lists its flags.", app.get_name());
  if (isFlag(word))
    throw UsageError(fmt::format("{} has no flag {}.", atRoot ? "blossom" : app.get_name(), word.substr(0, word.find('='))),
                     didYouMean(word.substr(0, word.find('=')), flagsOf(app), help), ErrorCode::NotFound);
  if (atRoot)
    throw UsageError(fmt::format("There is no command \"{}\".", word), didYouMean(word, line.commandNames(), help),
                     ErrorCode::NotFound);
  throw UsageError(fmt::format("{} has no use for \"{}\".", app.get_name(), word), help);
}

const Subcommand* chosenCommand(const CommandLine& line) {
  for (const Subcommand& command : line.commands)
    if (command.app->parsed()) return &command;
  return nullptr;
}

void warnAboutPlugins(const App& app, const Terminal& terminal) {
  for (const LoadedPlugin& plugin : app.plugins)
    if (!plugin.problem.empty())
      terminal.err << "blossom: warning: the plugin " << plugin.manifest.id << " was skipped: " << plugin.problem << '\n';
}

/// CLI11 asks for help and version by exception; what nobody understood is said first.
int parseAndRun(CommandLine& line, Invocation& invocation, std::vector<std::string> words) {
  std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
  try {
    line.root.parse(std::move(words));
  } catch (const CLI::Success& request) {
    if (!line.root.remaining(false).empty()) refuseWord(line, line.root, line.root.remaining(false));
    line.root.exit(request, invocation.terminal.out, invocation.terminal.err);
    return Done;
  } catch (const CLI::ArgumentMismatch& error) {
    // "--output: 1 required FILE,.. missing"
    const std::string what = error.what();
    const Subcommand* command = chosenCommand(line);
    throw UsageError(what.substr(0, what.find(':')) + " needs a value.",
                     fmt::format("\"blossom {}--help\" lists the flags and what they take.",
                                 command ? command->app->get_name() + " " : ""));
  } catch (const CLI::ParseError& error) {
    const Subcommand* command = chosenCommand(line);
    throw UsageError(error.what(), command ? fmt::format("\"blossom {} --help\" lists its flags.", command->app->get_name())
                                           : "\"blossom --help\" lists the commands.");
  }
  const Subcommand* command = chosenCommand(line);
  if (!line.root.remaining(false).empty()) refuseWord(line, line.root, line.root.remaining(false));
  if (!command) throw UsageError("A command is missing.", "\"blossom --help\" lists the commands.");
  if (!command->app->remaining(true).empty()) refuseWord(line, *command->app, command->app->remaining(true));
  setThreadLimit(invocation.threads);
  return command->run();
}

int guarded(const Terminal& terminal, bool json, const std::function<int()>& work) {
  try {
    return work();
  } catch (const UsageError& error) {
    printError(terminal, error, json);
    return WrongUse;
  } catch (const Error& error) {
    printError(terminal, error, json);
  } catch (const std::bad_alloc&) {
    printError(terminal, Error(ErrorCode::LimitExceeded, "There is not enough memory for this."), json);
  } catch (const std::exception& error) {
    printError(
        terminal,
        Error(ErrorCode::Internal, fmt::format("Something broke inside Blossom: {}", error.what()), "Please report this."),
        json);
  }
  return Failed;
}

int runWords(const App& app, const std::vector<std::string>& words, const Terminal& terminal, const Stopwatch& watch) {
  Invocation invocation{app, terminal, watch};
  warnAboutPlugins(app, terminal);
  CommandLine line;
  for (const auto add : {addConvertCommand, addInfoCommand, addRenderCommand, addRunCommand, addFeaturesCommand,
                         addFormatsCommand, addPluginsCommand, addCompletionCommand, addHelpCommand, addFeatureCommands})
    add(line, invocation);
  return parseAndRun(line, invocation, words);
}

/// Loads what is needed, runs, and sees that the result has really left the program.
int runGuarded(int argc, const char* const* argv, const Terminal& terminal, const App* given) {
  const Stopwatch watch;
  const std::vector<std::string> words = wordsOf(argc, argv);
  const int code = guarded(terminal, asksForJson(words), [&] {
    if (words.size() == 1 && words[0] == "--version") {  // needs no plugin
      terminal.out << "blossom " << versionText << '\n';
      return static_cast<int>(Done);
    }
    return runWords(given ? *given : loadApp(), words, terminal, watch);
  });
  terminal.out.flush();
  return terminal.out.fail() && code == Done ? Failed : code;
}

}  // namespace

int runCli(int argc, const char* const* argv, const Terminal& terminal) { return runGuarded(argc, argv, terminal, nullptr); }

int runCli(const App& app, int argc, const char* const* argv, const Terminal& terminal) {
  return runGuarded(argc, argv, terminal, &app);
}

}  // namespace blossom
