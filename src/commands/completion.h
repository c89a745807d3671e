// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMPLETION_H
#define CGAL_REEB_GRAPH_SRC_COMPLETION_H

#include "commands/command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

// Scripts by which shells complete commands, their options, values of these, and names of files.
namespace reeb_graph_program {
inline std::vector<const CLI::App*> commands_of(const CLI::App& app)
{
  return app.get_subcommands([](const CLI::App*) { return true; });
}

// The long names of the options of a command, each with what is in front and behind.
inline std::string options_of(const CLI::App& command, const std::string& before, const std::string& behind)
{
  std::string text;
  for(const CLI::Option* option : command.get_options())
    for(const std::string& name : option->get_lnames())
      text += before + name + behind;
  return text;
}

// The names that an option takes, with spaces between them: those that it checks, which stand in the name of its type, or
// those that are suggested.
inline std::string values_of(const CLI::Option& option)
{
  const auto suggested = suggested_values().find(&option);
  if(suggested != suggested_values().end())
    return suggested->second;
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{');
  std::string values = begin == std::string::npos ? "" : type.substr(begin + 1, type.find('}') - begin - 1);
  std::replace(values.begin(), values.end(), ',', ' ');
  return values;
}

// Calls visit(name, values) for each option of a command that takes names.
template <class Visit>
void for_each_option_of_names(const CLI::App& command, const Visit& visit)
{
  for(const CLI::Option* option : command.get_options())
    for(const std::string& name : option->get_lnames())
      if(const std::string values = values_of(*option); !values.empty())
        visit(name, values);
}

// The cases of bash and zsh for what is behind an option: `complete` is what offers the values that stand behind it.
inline std::string cases_of_values(const CLI::App& app, const std::string& complete, const std::string& end)
{
  std::string text;
  const auto add = [&](const std::string& first_word, const std::string& name, const std::string& values) {
    text += "      '" + first_word + " --" + name + "') " + complete + values + end + "; return ;;\n";
  };
  for_each_option_of_names(app, [&](const auto& name, const auto& values) { add("--" + name, name, values); });
  for(const CLI::App* command : commands_of(app))
    for_each_option_of_names(*command,
                             [&](const auto& name, const auto& values) { add(command->get_name(), name, values); });
  return text;
}

inline void write_bash_completion(std::ostream& out, const CLI::App& app)
{
  std::string names;
  for(const CLI::App* command : commands_of(app))
    names += command->get_name() + " ";
  out << "_reeb_graph() {\n  local words=\"" << names << options_of(app, "--", " ") << "\"\n"
      << "  if [[ $COMP_CWORD -gt 1 ]]; then\n    case \"${COMP_WORDS[1]} $3\" in\n"
      << cases_of_values(app, "COMPREPLY=($(compgen -W \"", "\" -- \"$2\"))")
      << "    esac\n    case ${COMP_WORDS[1]} in\n";
  for(const CLI::App* command : commands_of(app))
    out << "      " << command->get_name() << ") words=\"" << options_of(*command, "--", " ") << "\" ;;\n";
  out << "    esac\n    [[ $2 == -* ]] || words=\n  fi\n  COMPREPLY=($(compgen -W \"$words\" -- \"$2\"))\n}\n"
      << "complete -o default -F _reeb_graph " << app.get_name() << '\n';
}

inline void write_fish_completion(std::ostream& out, const CLI::App& app)
{
  const std::string complete = "complete -c " + app.get_name(), at_begin = " -n __fish_use_subcommand";
  const auto write_options = [&](const CLI::App& command, const std::string& when) {
    out << options_of(command, complete + when + " -l ", "\n");
    for_each_option_of_names(command, [&](const auto& name, const auto& values) {
      out << complete << when << " -l " << name << " -x -a '" << values << "'\n";
    });
  };
  for(const CLI::App* command : commands_of(app))
  {
    out << complete << at_begin << " -f -a " << command->get_name() << '\n';
    write_options(*command, " -n '__fish_seen_subcommand_from " + command->get_name() + "'");
  }
  write_options(app, at_begin);
}

// To be a file in a folder of functions, or to be read by `source`.
inline void write_zsh_completion(std::ostream& out, const CLI::App& app)
{
  out << "#compdef " << app.get_name() << "\n_reeb_graph() {\n  local -a words_of_command=(";
  for(const CLI::App* command : commands_of(app))
    out << command->get_name() << ' ';
  out << options_of(app, "--", " ") << ")\n  if (( CURRENT > 2 )); then\n    case \"$words[2] $words[CURRENT-1]\" in\n"
      << cases_of_values(app, "compadd -- ", "") << "    esac\n    case $words[2] in\n";
  for(const CLI::App* command : commands_of(app))
    out << "      " << command->get_name() << ") words_of_command=(" << options_of(*command, "--", " ") << ") ;;\n";
  out << "    esac\n    if [[ $PREFIX != -* ]]; then _files; return; fi\n  fi\n  compadd -- $words_of_command\n}\n"
      << "if [[ $funcstack[1] == _reeb_graph ]]; then _reeb_graph; else\n"
      << "  autoload -U +X compinit && compinit\n  compdef _reeb_graph " << app.get_name() << "\nfi\n";
}

inline void write_completion(std::ostream& out, const CLI::App& app, const std::string& shell)
{
  shell == "fish"  ? write_fish_completion(out, app)
  : shell == "zsh" ? write_zsh_completion(out, app)
                   : write_bash_completion(out, app);
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COMPLETION_H
