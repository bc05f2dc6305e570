#include <fmt/format.h>

#include <ostream>

#include "cli/command_line.h"

/// Completion scripts are printed, not looked up while typing: every command, flag and choice of this installation stands in
/// them.
namespace blossom {
namespace {

/// In single quotes for any of the shells. fish, bash and zsh all read '\'' as an end, a quote and a start.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text)
    if (c == '\'')
      result += "'\\''";
    else
      result += c;
  return result + "'";
}

bool expectsValue(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::vector<std::string> flagNames(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const auto& name : option.get_snames()) names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string bashScript(const CommandLine& line) {
  std::string flags, choices;
  for (const Subcommand& command : line.commands) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.app->get_options()) {
      for (const auto& name : flagNames(*option)) names.push_back(name);
      if (const auto found = line.choices.find(option); found != line.choices.end())
        for (const auto& name : flagNames(*option))
          choices += fmt::format("    {}:{}) words={} ;;\n", command.app->get_name(), name, quoted(joined(found->second)));
    }
    flags += fmt::format("      {}) words={} ;;\n", command.app->get_name(), quoted(joined(names)));
  }
  return fmt::format(R"(# bash completion for blossom; load it with: source <(blossom completion bash)
_blossom() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}} words=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W {} -- "$current"))
    return
  fi
  case "$command:$previous" in
{}  esac
  if [ -z "$words" ] && [[ $current == -* ]]; then
    case "$command" in
{}    esac
  fi
  [ -z "$words" ] || COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o default -o bashdefault -F _blossom blossom
)",
                     quoted(joined(line.commandNames()) + " --help --version"), choices, flags);
}

/// zsh's _arguments gives brackets and colons a meaning.
std::string zshText(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zshScript(const CommandLine& line) {
  std::string commands, cases;
  for (const Subcommand& command : line.commands) {
    commands += fmt::format("    {}\n", quoted(command.app->get_name() + ":" + zshText(command.app->get_description())));
    cases += fmt::format("    {})\n      _arguments", command.app->get_name());
    for (const CLI::Option* option : command.app->get_options()) {
      const auto found = line.choices.find(option);
      const std::string value = !expectsValue(*option)        ? ""
                                : found == line.choices.end() ? ":value:_files"
                                                              : ":value:(" + joined(found->second) + ")";
      for (const auto& name : flagNames(*option))
        cases += fmt::format(" \\\n        {}",
                             quoted(fmt::format("*{}[{}]{}", name, zshText(option->get_description()), value)));
    }
    cases += " \\\n        '*:file:_files'\n      ;;\n";
  }
  return fmt::format(R"(#compdef blossom
# zsh completion for blossom; load it with: source <(blossom completion zsh)
_blossom() {{
  local -a commands
  commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{}  esac
}}
compdef _blossom blossom
)",
                     commands, cases);
}

std::string fishScript(const CommandLine& line) {
  std::string script = "# fish completion for blossom; load it with: blossom completion fish | source\n";
  for (const Subcommand& command : line.commands) {
    const std::string name = command.app->get_name();
    script += fmt::format("complete -c blossom -n __fish_use_subcommand -f -a {} -d {}\n", quoted(name),
                          quoted(command.app->get_description()));
    for (const CLI::Option* option : command.app->get_options()) {
      if (flagNames(*option).empty()) continue;
      script += fmt::format("complete -c blossom -n '__fish_seen_subcommand_from {}'", name);
      for (const auto& flag : option->get_snames()) script += " -s " + flag;
      for (const auto& flag : option->get_lnames()) script += " -l " + quoted(flag);
      const auto found = line.choices.find(option);
      if (found != line.choices.end())
        script += " -xa " + quoted(joined(found->second));
      else if (expectsValue(*option))
        script += " -r";
      script += " -d " + quoted(option->get_description()) + "\n";
    }
  }
  return script;
}

struct CompletionCommand {
  CompletionCommand(CommandLine& line, Invocation& invocation) {
    CLI::App& app = line.add("completion", "Print a script that completes commands and flags in a shell.", invocation,
                             [this, &line, &invocation] {
                               if (shell == "bash")
                                 invocation.terminal.out << bashScript(line);
                               else if (shell == "zsh")
                                 invocation.terminal.out << zshScript(line);
                               else if (shell == "fish")
                                 invocation.terminal.out << fishScript(line);
                               else
                                 throw UsageError(shell.empty() ? "completion needs the name of a shell."
                                                                : fmt::format("There is no completion for \"{}\".", shell),
                                                  "Write bash, zsh or fish.");
                               return 0;
                             });
    app.add_option("SHELL", shell, "bash, zsh or fish.")->type_name("");
    setExamples(
        app, {"source <(blossom completion bash)", "source <(blossom completion zsh)", "blossom completion fish | source"});
  }
  std::string shell;
};

}  // namespace

void addCompletionCommand(CommandLine& line, Invocation& invocation) {
  line.keep(std::make_shared<CompletionCommand>(line, invocation));
}

}  // namespace blossom
