// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMPLETION_H
#define CGAL_REEB_GRAPH_SRC_COMPLETION_H

#include <CLI/CLI.hpp>

#include <ostream>
#include <string>
#include <vector>

// Scripts by which shells complete commands, their options, and names of files.
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

inline void write_bash_completion(std::ostream& out, const CLI::App& app)
{
  std::string names;
  for(const CLI::App* command : commands_of(app))
    names += command->get_name() + " ";
  out << "_reeb_graph() {\n  local words=\"" << names << options_of(app, "--", " ") << "\"\n"
      << "  if [[ $COMP_CWORD -gt 1 ]]; then\n    case ${COMP_WORDS[1]} in\n";
  for(const CLI::App* command : commands_of(app))
    out << "      " << command->get_name() << ") words=\"" << options_of(*command, "--", " ") << "\" ;;\n";
  out << "    esac\n    [[ $2 == -* ]] || words=\n  fi\n  COMPREPLY=($(compgen -W \"$words\" -- \"$2\"))\n}\n"
      << "complete -o default -F _reeb_graph " << app.get_name() << '\n';
}

inline void write_fish_completion(std::ostream& out, const CLI::App& app)
{
  const std::string complete = "complete -c " + app.get_name();
  for(const CLI::App* command : commands_of(app))
    out << complete << " -n __fish_use_subcommand -f -a " << command->get_name() << '\n'
        << options_of(*command, complete + " -n '__fish_seen_subcommand_from " + command->get_name() + "' -l ", "\n");
  out << options_of(app, complete + " -n __fish_use_subcommand -l ", "\n");
}

// To be a file in a folder of functions, or to be read by `source`.
inline void write_zsh_completion(std::ostream& out, const CLI::App& app)
{
  out << "#compdef " << app.get_name() << "\n_reeb_graph() {\n  local -a words_of_command=(";
  for(const CLI::App* command : commands_of(app))
    out << command->get_name() << ' ';
  out << options_of(app, "--", " ") << ")\n  if (( CURRENT > 2 )); then\n    case $words[2] in\n";
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
