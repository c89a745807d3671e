// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MANUAL_PAGE_H
#define CGAL_REEB_GRAPH_SRC_MANUAL_PAGE_H

#include "commands/completion.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <sstream>
#include <string>

// The pages of man(1), of the program and of each command, from what --help prints.
namespace reeb_graph_program {
class Manual_page
{
public:
  Manual_page(std::ostream& out, const CLI::App& command, const std::string& version) : out_(out), command_(command)
  {
    const CLI::App* app = command.get_parent();
    name_ = app ? app->get_name() + "-" + command.get_name() : command.get_name();
    out << ".TH " << upper_case(escaped(name_)) << " 1 \"\" \"reeb_graph " << version << "\"\n";
    begin_section("NAME");
    out << escaped(name_ + " - " + command.get_description()) << '\n';
    begin_section("SYNOPSIS");
    write_synopsis(app);
    write_options();
    write_commands();
    write_footer();
    begin_section("SEE ALSO");
    const CLI::App& program = app ? *app : command;
    std::string pages = app ? ".BR " + escaped(program.get_name()) + " (1)" : "";
    for(const CLI::App* other : commands_of(program))
      if(other != &command)
        pages += (pages.empty() ? ".BR " : ",\n.BR ") + escaped(program.get_name() + "-" + other->get_name()) + " (1)";
    out << pages << '\n';
  }

private:
  // What is no letter of a text to troff.
  static std::string escaped(const std::string& text)
  {
    std::string result = !text.empty() && (text[0] == '.' || text[0] == '\'') ? "\\&" : "";
    for(const char c : text)
      result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    return result;
  }

  static std::string upper_case(std::string text)
  {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    return text;
  }

  void begin_section(const std::string& title) { out_ << ".SH " << upper_case(title) << '\n'; }

  void write_synopsis(const CLI::App* app)
  {
    out_ << ".B " << escaped(app ? app->get_name() + " " + command_.get_name() : name_) << "\n[OPTIONS]";
    for(const CLI::Option* option : command_.get_options())
      if(option->get_positional())
        out_ << ' ' << escaped(option->get_name(true));
    out_ << (app ? "\n" : " COMMAND\n");
  }

  void write_options()
  {
    const CLI::Formatter formatter;
    for(const std::string& group : command_.get_groups())
    {
      begin_section(group.empty() ? "Options" : group);
      for(const CLI::Option* option : command_.get_options())
        if(option->get_group() == group)
          out_ << ".TP\n.B " << escaped(option->get_name(option->get_positional(), !option->get_positional())) << "\\fR"
               << escaped(formatter.make_option_opts(option)) << '\n'
               << escaped(option->get_description()) << '\n';
    }
  }

  void write_commands()
  {
    if(commands_of(command_).empty())
      return;
    begin_section("Commands");
    for(const CLI::App* command : commands_of(command_))
      out_ << ".TP\n.B " << escaped(command->get_name()) << '\n' << escaped(command->get_description()) << '\n';
  }

  // Lines that end with a colon are titles, and what follows stays as it is.
  void write_footer()
  {
    std::istringstream lines(command_.get_footer());
    for(std::string line; std::getline(lines, line);)
      if(!line.empty() && line.back() == ':')
      {
        out_ << (is_verbatim_ ? ".fi\n" : "");
        begin_section(line.substr(0, line.size() - 1));
        out_ << ".nf\n";
        is_verbatim_ = true;
      }
      else if(!line.empty())
        out_ << escaped(line) << '\n';
    out_ << (is_verbatim_ ? ".fi\n" : "");
  }

  std::ostream& out_;
  const CLI::App& command_;
  std::string name_;
  bool is_verbatim_ = false;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MANUAL_PAGE_H
