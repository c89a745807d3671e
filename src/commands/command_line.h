// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMMAND_LINE_H
#define CGAL_REEB_GRAPH_SRC_COMMAND_LINE_H

#include "base/threads.h"
#include "commands/commands.h"
#include "input/field_input.h"
#include "input/input_error.h"
#include "input/text_input.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace reeb_graph_program {
// What --help prints: options in groups, a list of the fields, and an example, in lines of at most 100 characters.
class Help_formatter : public CLI::Formatter
{
  std::string make_option_desc(const CLI::Option* option) const override
  {
    constexpr std::size_t width = 68; // beside the column of names
    std::istringstream words(CLI::Formatter::make_option_desc(option));
    std::string text;
    std::size_t length = 0;
    for(std::string word; words >> word; length += word.size())
    {
      if(length != 0)
        text += length + 1 + word.size() > width ? '\n' : ' ';
      length = text.empty() || text.back() == '\n' ? 0 : length + 1;
      text += word;
    }
    return text;
  }
};

// Values that shells complete for an option, besides those that it checks itself.
inline std::map<const CLI::Option*, std::string>& suggested_values()
{
  static std::map<const CLI::Option*, std::string> values;
  return values;
}

// Lets shells complete these values, between which there are spaces. Others are possible.
inline CLI::Option* suggest(const std::string& values, CLI::Option* option)
{
  suggested_values()[option] = values;
  return option;
}

// Puts the options that are added next under this heading.
inline void begin_group(CLI::App& command, const std::string& name) { command.option_defaults()->group(name); }

inline const std::string coordinate_fields = "  x, y, z                   a coordinate\n";
inline const std::string height_field = "  height                    along --direction, by default 0,0,1\n";
inline const std::string computed_fields =
  height_field
  + "  harmonic                  0 at the vertex --min and 1 at --max, or between two vertices of each\n"
    "                            component that are far apart\n"
    "  harmonic-between-borders  0 on the first border of a component and 1 on its others; if there is\n"
    "                            one border only, 1 at a vertex far from it\n"
    "  poisson                   follows mean curvature, with 0 at the vertices --source, or at a tip\n"
    "  geodesic                  the distance from the vertices --source, or from a tip\n"
    "  unit-gradient             follows --scalars, or else harmonic, with gradients of length 1\n";
inline const std::vector<std::string> names_of_computed_fields = {"height",  "harmonic", "harmonic-between-borders",
                                                                  "poisson", "geodesic", "unit-gradient"};
inline const std::string fields_of_files =
  "  NAME                      a property of the vertices of a PLY, VTK, VTU, or VTP file\n";

// Both stand behind the options, in this order.
inline void add_list_of_fields(CLI::App& command, const std::string& option, const std::string& fields)
{
  command.footer("Fields, for " + option + ":\n" + fields);
}

inline void add_example(CLI::App& command, const std::string& example)
{
  const std::string footer = command.get_footer();
  command.footer(footer + (footer.empty() ? "" : "\n") + "Example:\n  " + example);
}

// Options whose values are numbers, read as those in files. CLI11 by itself wraps what is negative or too large around,
// takes a 0 in front for octal, and names bounds of hundreds of digits.
struct Whole_number_bounds
{
  std::size_t lowest = 0, highest = (std::numeric_limits<std::size_t>::max)();
};

inline std::size_t parse_whole_number(const std::string& option, const std::string& text, Whole_number_bounds bounds)
{
  const bool is_negative = text.size() > 1 && text[0] == '-';
  std::size_t number = 0;
  const std::errc error = parse_number(std::string_view(text).substr(is_negative ? 1 : 0), number);
  const bool is_too_large = error == std::errc::result_out_of_range;
  if(error != std::errc() && !is_too_large)
    throw CLI::ValidationError(option, quote(text) + " is not a whole number");
  if(is_negative ? is_too_large || number != 0 || bounds.lowest > 0 : !is_too_large && number < bounds.lowest)
    throw CLI::ValidationError(option, quote(text) + " is less than " + std::to_string(bounds.lowest));
  if(is_too_large || number > bounds.highest)
    throw CLI::ValidationError(option, quote(text) + " is more than " + std::to_string(bounds.highest));
  return number;
}

inline double parse_real_number(const std::string& option, const std::string& text)
{
  double number = 0;
  std::errc error = parse_number(text, number);
  if(error == std::errc::result_out_of_range)
  {
    number = std::strtod(text.c_str(), nullptr);
    if(!(std::abs(number) < 1))
      throw CLI::ValidationError(option, quote(text) + " is too large");
  }
  else if(error != std::errc())
    throw CLI::ValidationError(option, quote(text) + " is not a number");
  return number;
}

template <class Variable>
CLI::Option* add_whole_number(CLI::App& command,
                              const std::string& name,
                              Variable& variable,
                              const std::string& description,
                              Whole_number_bounds bounds = {})
{
  const auto set = [&variable, name, bounds](const std::string& text) {
    variable = parse_whole_number(name, text, bounds);
  };
  return command.add_option_function<std::string>(name, set, description)->type_name("UINT");
}

template <class Variable>
CLI::Option* add_real_number(CLI::App& command,
                             const std::string& name,
                             Variable& variable,
                             const std::string& description)
{
  const auto set = [&variable, name](const std::string& text) { variable = parse_real_number(name, text); };
  return command.add_option_function<std::string>(name, set, description)->type_name("FLOAT");
}

// Numbers with commas between them.
template <class Number, class Parse>
CLI::Option* add_numbers(CLI::App& command,
                         const std::string& name,
                         std::vector<Number>& variable,
                         const std::string& description,
                         const Parse& parse)
{
  const auto set = [&variable, name, parse](const std::vector<std::string>& texts) {
    variable.clear();
    for(const std::string& text : texts)
      variable.push_back(parse(name, text));
  };
  return command.add_option_function<std::vector<std::string>>(name, set, description)->delimiter(',');
}

// Names, each of which stands for a value, and an option that takes one of them.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

template <class Variable, class Value>
CLI::Option* add_choice(CLI::App& command,
                        const std::string& name,
                        Variable& variable,
                        const Choices<Value>& choices,
                        const std::string& description)
{
  std::vector<std::string> names;
  for(const auto& choice : choices)
    names.push_back(choice.first);
  const auto set = [&variable, choices](const std::string& chosen) {
    for(const auto& [name_of_value, value] : choices)
      if(name_of_value == chosen)
        variable = value;
  };
  return command.add_option_function<std::string>(name, set, description)->check(CLI::IsMember(names));
}

// A number that can be given several times.
inline void add_values(CLI::App& command,
                       const std::string& name,
                       std::vector<double>& values,
                       const std::string& description)
{
  const auto add = [&values, name](const std::vector<std::string>& texts) {
    for(const std::string& text : texts)
      values.push_back(parse_real_number(name, text));
  };
  command.add_option_function<std::vector<std::string>>(name, add, description)
    ->type_name("FLOAT")
    ->allow_extra_args(false);
}

// Names of files, and of fields, of which an empty one is a mistake, such as a variable of a script that is not set.
inline CLI::Validator is_not_empty()
{
  return CLI::Validator([](const std::string& name) { return name.empty() ? "it is empty" : ""; }, "");
}

template <class Path>
CLI::Option* add_file(CLI::App& command, const std::string& name, Path& path, const std::string& description)
{
  return command.add_option(name, path, description)->check(is_not_empty());
}

// --output, which takes one file or several. The last of several is the mesh if no other one is named.
inline CLI::Option* add_output_files(CLI::App& command, std::vector<std::string>& paths, const std::string& description)
{
  CLI::Option* const mesh = command.get_option("MESH");
  const auto set = [&paths, mesh](const std::vector<std::string>& given) {
    paths = given;
    if(mesh->count() > 0 || paths.size() < 2)
      return;
    mesh->add_result(paths.back());
    mesh->run_callback();
    paths.pop_back();
  };
  return command.add_option_function<std::vector<std::string>>("--output", set, description)
    ->type_name("FILE")
    ->check(is_not_empty());
}

// The options that commands and programs share.
inline void add_format_option(CLI::App& command)
{
  static const std::vector<std::string> formats = {"off", "obj", "ply", "stl", "ts",  "mesh",
                                                   "vtk", "vtu", "vtp", "txt", "csv", "npy"};
  const auto set_format = [](const std::string& format) {
    const std::string name = lower_case(format[0] == '.' ? format.substr(1) : format);
    if(std::find(formats.begin(), formats.end(), name) == formats.end())
      throw CLI::ValidationError("--format", quote(format)
                                               + " is not a format that is read: those of meshes are off, "
                                                 "obj, ply, stl, ts, mesh, vtk, vtu, and vtp, those of "
                                                 "fields are txt, csv, and npy");
    extension_of_standard_input() = '.' + name;
  };
  suggest(CLI::detail::join(formats, " "),
          command.add_option_function<std::string>(
            "--format", set_format,
            "The format of what is read from standard input, -: that of a mesh as files have it in their names, or txt "
            "(the default), csv, or npy of --scalars"))
    ->type_name("NAME");
}

// `path` is one name, or several ones.
template <class Path>
void add_mesh_file(CLI::App& command, const std::string& name, Path& path, Input_options& options)
{
  add_file(command, name, path,
           "The mesh: an OFF, OBJ, PLY, STL, TS, MESH, VTK, VTU, or VTP file, or - for standard input")
    ->required();
  add_format_option(command);
  command.add_flag("--triangulate", options.are_faces_triangulated, "Cut faces that are not triangles into triangles");
}

inline void add_mesh_file(CLI::App& command, Input_options& options)
{
  add_mesh_file(command, "MESH", options.mesh_path, options);
}

inline std::size_t parse_vertex(const std::string& name, const std::string& text)
{
  return parse_whole_number(name, text, {});
}

// Options of a field but for what each mesh has of its own.
inline void add_field_settings(CLI::App& command, Input_options& options)
{
  command.add_option("--column", options.column,
                     "The column of a CSV file with several columns: its name, or its number from 0");
  add_whole_number(command, "--min", options.lowest_vertex,
                   "For harmonic: the vertex of value 0, by its number in the mesh file, from 0");
  add_whole_number(command, "--max", options.highest_vertex, "For harmonic: the vertex of value 1");
  command
    .add_option("--weights", options.weights, "For harmonic fields: mean-value (the default), cotangent, or uniform")
    ->check(CLI::IsMember({"mean-value", "cotangent", "uniform"}));
  add_numbers(command, "--direction", options.direction, "For height: the direction, as X,Y,Z; by default 0,0,1",
              parse_real_number)
    ->type_name("FLOAT")
    ->expected(3);
}

inline const std::string file_of_scalars =
  "A file with the field: one number per line, in the vertex order of the mesh file, or CSV, or NumPy's .npy; - for "
  "standard input";
inline const std::string source_vertices = "For poisson and geodesic: the vertices of value 0, as V,W,...";

inline void add_input_options(CLI::App& command, Input_options& options)
{
  begin_group(command, "Input");
  add_mesh_file(command, options);
  begin_group(command, "Field");
  add_file(command, "--scalars", options.scalars_path, file_of_scalars);
  add_field_settings(command, options);
  add_numbers(command, "--source", options.source_vertices, source_vertices, parse_vertex)
    ->type_name("UINT")
    ->allow_extra_args(false);
}

inline void add_strict_option(CLI::App& command, Input_options& options, const std::string& when = "")
{
  command.add_flag(
    "--strict", options.is_strict,
    when
      + "Refuse a mesh that is not an oriented manifold surface. By default, a copy of it is repaired, as "
        "by repair --all, and vertices keep their numbers"
      + (when.empty() ? ". Of tetrahedra, the border is taken" : ""));
}

inline void add_field_option(CLI::App& command, Input_options& options, const std::string& default_field = "")
{
  suggest("x y z " + CLI::detail::join(names_of_computed_fields, " "),
          command.add_option("--field", options.field, "The field, one of the list at the end" + default_field))
    ->check(is_not_empty());
  add_list_of_fields(command, "--field", coordinate_fields + computed_fields + fields_of_files);
}

// `shown` is what the page shows, and `unit` what --unit is the unit of.
inline void add_page_options(CLI::App& command,
                             Command_options& options,
                             const std::string& shown = "the graph on the surface",
                             const std::string& unit = "the field, for the page and for the drawing of the graph")
{
  add_file(command, "--html", options.page_path, "Write a page to this file, .html, that shows " + shown);
  command
    .add_option("--up", options.up,
                "With --html: the upward direction, x, y, z, -x, -y, or -z. By default, it is the direction of a "
                "height. For other "
                "fields, it is away from the largest flat side, as if the mesh stands on that. Without such a side, it "
                "is y for a "
                "mesh that is as tall in y as it is wide, and z for others")
    ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}));
  command.add_option("--unit", options.unit, "The unit of " + unit);
}

inline void add_threads_option(CLI::App& command, std::size_t& number_of_threads)
{
  add_whole_number(command, "--threads", number_of_threads, "Work with this many threads, by default one per core",
                   {1, largest_number_of_threads});
}

inline void add_json_option(CLI::App& command, bool& is_report_json)
{
  command.add_flag("--json", is_report_json, "Print the report as one JSON object");
}

inline void add_ties_option(CLI::App& command, Graph_options& options, const std::string& description)
{
  using CGAL::Reeb_graph::Ties;
  add_choice(command, "--ties", options.ties, Choices<Ties>{{"perturb", Ties::PERTURB}, {"contract", Ties::CONTRACT}},
             description);
}

inline void add_graph_options(CLI::App& command, Graph_options& options)
{
  using CGAL::Reeb_graph::Method;
  begin_group(command, "Graph");
  command.add_flag("--keep-degree-2", options.are_degree_two_nodes_kept,
                   "Keep critical vertices with one arc below and one above as nodes");
  add_ties_option(command, options,
                  "Order vertices of equal value by their numbers (perturb, the default), or contract arcs of length "
                  "zero (contract)");
  add_choice(
    command, "--method", options.method,
    Choices<Method>{
      {"auto", Method::AUTOMATIC}, {"critical-sets", Method::CRITICAL_SETS}, {"contour-trees", Method::CONTOUR_TREES}},
    "The method that finds the arcs: auto (the default), critical-sets, or contour-trees; the graph is the same");
  add_threads_option(command, options.number_of_threads);
  add_whole_number(command, "--slabs", options.number_of_slabs,
                   "Cut the surface at level sets into this many slabs, which threads share; the graph is the same",
                   {1});
}

inline void add_simplification_options(CLI::App& command, Simplification_options& options)
{
  begin_group(command, "Simplification");
  suggest("auto",
          command.add_option_function<std::string>(
            "--simplify", [&options](const std::string& text) { options.threshold = parse_threshold(text); },
            "Remove branches of the graph that are less persistent than this: X in units of the field, P% of its "
            "range, or auto, the threshold that best separates noise from features"));
  add_whole_number(command, "--leaves", options.number_of_leaves,
                   "Remove branches until the graph has this many leaves");
  command.add_flag("--cancel-loops", options.are_loops_cancelled, "With --simplify: remove loops as well");
}

inline void add_graph_file(CLI::App& command, std::string& path)
{
  add_file(command, "--graph", path,
           "Write the graph to this file: .graphml, .dot, .svg, or as lines in space .vtp, .obj, .polylines.txt, "
           ".json, or .csv, which makes two files, .nodes.csv and .arcs.csv");
}

// The command without what it does.
inline CLI::App* add_compute_command(CLI::App& app, Compute_options& options)
{
  CLI::App* command =
    app.add_subcommand("compute", "Compute the Reeb graph of a field on a mesh of triangles or tetrahedra");
  add_input_options(*command, options.input);
  add_field_option(*command, options.input);
  add_strict_option(*command, options.input, "With --html: ");
  add_graph_options(*command, options.graph);
  add_simplification_options(*command, options.simplification);
  begin_group(*command, "Output");
  add_graph_file(*command, options.graph_path);
  using CGAL::Reeb_graph::Embedding_manner;
  add_choice(
    *command, "--embedding", options.embedding_manner,
    Choices<Embedding_manner>{{"centroids", Embedding_manner::CENTROIDS},
                              {"on-surface", Embedding_manner::ON_SURFACE},
                              {"straight", Embedding_manner::STRAIGHT}},
    "The way of arcs in space: through centroids of contours (centroids), along chains (on-surface), or straight "
    "from vertex to vertex (straight). The default is centroids, but straight for .csv, where contours are very "
    "long, "
    "and if the mesh is not an oriented manifold surface");
  add_file(*command, "--mesh-out", options.mesh_path,
           "Write the mesh to this file, .ply or .vtp, with the value, the arc, and the node of each vertex, "
           "and colors; .off has the colors alone, .obj and .stl have none");
  add_file(*command, "--vertex-arcs", options.vertex_arcs_path,
           "Write the arc or node of each vertex to this file, one per line; in .npy, the number of the node, or the "
           "number of nodes plus that of the arc");
  add_file(*command, "--pairs", options.pairs_path,
           "Write the pairs of extended persistence to this file, .csv, or .pers for GUDHI; as before --simplify");
  add_file(*command, "--diagram", options.diagram_path,
           "Draw the persistence diagram of these pairs to this file, .svg");
  add_file(*command, "--longest-loop", options.loop_path,
           "Write the most persistent loop of the graph to this file, as a closed curve on the surface: .vtp, .obj, or "
           ".polylines.txt; --html shows it, too");
  add_page_options(*command, options);
  add_file(*command, "--simplified-scalars", options.simplified_scalars_path,
           "With --simplify or --leaves: write a field whose graph is the simplified one to this file; .npy for NumPy");
  CLI::Option* table = command->add_flag_callback(
    "--table", [&options] { options.is_table_wanted = true; },
    "Print a table of the arcs with their ends, persistences, lengths, areas or volumes, and numbers of vertices; by "
    "default for graphs of up to 40 arcs");
  command
    ->add_flag_callback(
      "--no-table", [&options] { options.is_table_wanted = false; }, "Do not print this table")
    ->excludes(table);
  add_json_option(*command, options.is_report_json);
  add_example(*command, "reeb_graph compute scan.ply --field geodesic --simplify auto --html page.html");
  return command;
}

// How many characters have to be put in, taken out, or replaced to make one word of another one.
inline std::size_t number_of_edits(const std::string& from, const std::string& to)
{
  std::vector<std::size_t> edits(to.size() + 1);
  std::iota(edits.begin(), edits.end(), std::size_t(0));
  for(std::size_t i = 0; i != from.size(); ++i)
  {
    std::size_t before = std::exchange(edits[0], i + 1);
    for(std::size_t j = 0; j != to.size(); ++j)
    {
      const std::size_t replaced = before + (from[i] == to[j] ? 0 : 1);
      before = edits[j + 1];
      edits[j + 1] = std::min({replaced, before + 1, edits[j] + 1});
    }
  }
  return edits.back();
}

// What is said of an option that there is not: which one may be meant, as it begins in the same way, or differs least.
inline std::string describe_unknown_option(const CLI::App& command, const std::string& word)
{
  const std::string given = word.substr(0, word.find('='));
  std::string nearest;
  std::size_t least = given.size() / 2;
  for(const CLI::Option* option : command.get_options())
    for(const std::string& long_name : option->get_lnames())
    {
      const std::string name = "--" + long_name;
      const std::size_t edits = name.rfind(given, 0) == 0 ? 0 : number_of_edits(given, name);
      if(edits < least)
      {
        nearest = name;
        least = edits;
      }
    }
  return command.get_name() + " has no option " + quote(given)
       + (nearest.empty() ? "" : "; the nearest one is " + nearest);
}

// What is wrong with the command line; a missing or unknown command is named with those that there are.
inline std::string describe(const CLI::App& app, const CLI::ParseError& error)
{
  const std::string help = "\nRun with --help for more information.";
  std::string message = error.what();
  if(app.get_subcommands().empty() && error.get_name() == "RequiredError")
  {
    const std::vector<std::string> words = app.remaining();
    message = words.empty() ? "a command is needed" : "there is no command '" + words.front() + "'";
    for(const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
      message += (message.find(": ") == std::string::npos ? ": " : ", ") + command->get_name();
  }
  else if(error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) && !app.get_subcommands().empty())
  {
    for(const std::string& word : app.remaining(true))
      if(word.size() > 1 && word[0] == '-')
        return describe_unknown_option(*app.get_subcommands().front(), word) + help;
  }
  return message + help;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COMMAND_LINE_H
