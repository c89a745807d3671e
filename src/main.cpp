// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/message_of.h"
#include "base/threads.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/completion.h"
#include "output/output_file.h"

#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace reeb_graph_program {
namespace {
// Options of which one value is that of all meshes, and several are those of one each.
void add_fields_of_meshes(CLI::App& command, Compare_options& options)
{
  const std::string for_each = "; once for all meshes, or once for each, in their order";
  add_file(command, "--scalars", options.scalars_paths, file_of_scalars + for_each)->allow_extra_args(false);
  add_field_settings(command, options.input);
  const auto add_sources = [&options](const std::vector<std::string>& lists) {
    for(const std::string& list : lists)
    {
      std::vector<std::size_t>& sources = options.sources.emplace_back();
      for(const std::string& word : CLI::detail::split(list, ','))
        sources.push_back(parse_vertex("--source", word));
    }
  };
  command
    .add_option_function<std::vector<std::string>>(
      "--source", add_sources,
      source_vertices + for_each + "; by default the tips of the meshes that are most alike, if these are connected")
    ->type_name("UINT")
    ->allow_extra_args(false);
}

void add_compare_command(CLI::App& app, Compare_options& options)
{
  CLI::App* command =
    app.add_subcommand("compare", "Tell how far shapes are apart, and which limbs of two are the same");
  begin_group(*command, "Input");
  add_mesh_file(*command, "MESHES", options.mesh_paths, options.input);
  begin_group(*command, "Field");
  add_fields_of_meshes(*command, options);
  add_field_option(*command, options.input);
  add_strict_option(*command, options.input);
  add_graph_options(*command, options.graph);
  add_simplification_options(*command, options.simplification);
  begin_group(*command, "Comparison");
  add_real_number(*command, "--price-alone", options.price_alone,
                  "The price of an arc without partner, 1 by default: arcs that differ by more than twice of it are no "
                  "partners");
  begin_group(*command, "Output");
  add_file(*command, "--output", options.matrix_path,
           "Write the distances of all pairs of meshes to this file, .csv, with a row and a column for each mesh");
  add_page_options(*command, options, "two surfaces side by side, with arcs that are partners in one color");
  add_json_option(*command, options.is_report_json);
  add_example(*command, "reeb_graph compare a.ply b.ply --field geodesic --simplify auto --html page.html");
  command->callback(
    [&options] { run_with_threads(options.graph.number_of_threads, [&options] { run_compare(options); }); });
}

void add_contour_command(CLI::App& app, Contour_options& options)
{
  CLI::App* command =
    app.add_subcommand("contour", "Write contours, the components of level sets: lines, or triangles");
  Contour_choice& choice = options.choice;
  add_input_options(*command, options.input);
  add_field_option(*command, options.input);
  add_strict_option(*command, options.input, "With --html: ");
  add_graph_options(*command, choice.graph);
  add_simplification_options(*command, choice.simplification);
  begin_group(*command, "Contours, one of --t, --level, --levels, and --closest");
  add_real_number(*command, "--t", choice.t,
                  "The contour at this place of each arc, greater than 0 (low) and less than 1 (high)");
  add_whole_number(*command, "--arc", choice.arc,
                   "With --t: only the contour of this arc, by its number in files of the graph, from 0");
  add_file(*command, "--parametrize", options.parametrization,
           "With --t: measure places on arcs by another field than that of the graph, unit-gradient, whose equal steps "
           "are equal distances on the surface, or a file with one number per vertex, as of --scalars")
    ->type_name("unit-gradient|FILE");
  add_values(*command, "--level", choice.levels, "The contours just above this value; can be given several times");
  add_whole_number(*command, "--levels", choice.number_of_levels,
                   "The contours at this many values, which cut the range of the field into equal steps", {1});
  const auto set_point = [&choice](const std::vector<std::string>& texts) {
    std::array<double, 3> coordinates;
    std::transform(texts.begin(), texts.end(), coordinates.begin(),
                   [](const std::string& text) { return parse_real_number("--closest", text); });
    choice.point = Point(coordinates[0], coordinates[1], coordinates[2]);
  };
  command
    ->add_option_function<std::vector<std::string>>(
      "--closest", set_point, "The contour through the place on the mesh that is closest to the point X,Y,Z")
    ->delimiter(',')
    ->type_name("FLOAT")
    ->expected(3);
  begin_group(*command, "Output");
  add_output_files(
    *command, options.output_paths,
    "Write the contours to these files: .polylines.txt, or .off in tetrahedra; .vtp, .obj, .json, and .csv also have "
    "the arc, value, and length of each, and whether it is closed");
  add_page_options(*command, options);
  add_json_option(*command, options.is_report_json);
  add_example(*command, "reeb_graph contour scan.ply --field geodesic --simplify auto --t 0.5 --output contours.vtp");
  command->callback(
    [&options] { run_with_threads(options.choice.graph.number_of_threads, [&options] { run_contour(options); }); });
}

void add_level_options(CLI::App& command, Level_choice& levels)
{
  add_values(command, "--level", levels.values,
             "For levels: cut where the field has this value; can be given several times");
  add_whole_number(command, "--levels", levels.number,
                   "For levels: so many values, which cut the range of the field into equal steps", {1});
  add_real_number(command, "--spacing", levels.spacing,
                  "For levels: the multiples of this value inside of the range of the field");
}

void add_curves_command(CLI::App& app, Curves_options& options)
{
  CLI::App* command = app.add_subcommand("curves", "Cut a mesh into pants, branches, levels or disks, or to genus 0");
  add_input_options(*command, options.input);
  add_field_option(*command, options.input,
                   "; by default harmonic-between-borders if the mesh has borders, else harmonic");
  begin_group(*command, "Graph");
  add_ties_option(*command, options.graph,
                  "For --graph, --html, and --mesh-out: contract arcs of length zero (contract, the default), which "
                  "makes a level border one node, or order vertices of equal value by their numbers (perturb)");
  add_threads_option(*command, options.graph.number_of_threads);
  add_simplification_options(*command, options.simplification);
  begin_group(*command, "Curves");
  add_choice(*command, "--type", options.cut.type,
             Choices<Curves_type>{{"cutting-system", Curves_type::CUTTING_SYSTEM},
                                  {"pants", Curves_type::PANTS},
                                  {"branch", Curves_type::BRANCH},
                                  {"levels", Curves_type::LEVELS},
                                  {"disks", Curves_type::DISKS}},
             "Which curves: cutting-system, pants, branch, levels, or disks")
    ->required();
  add_level_options(*command, options.cut.levels);
  add_real_number(*command, "--persistence", options.cut.persistence,
                  "For branch: leave out branches that are less persistent than this");
  add_real_number(*command, "--area", options.cut.area, "For branch: leave out branches of less area than this");
  using CGAL::Reeb_graph::Borders;
  add_choice(*command, "--borders", options.cut.borders,
             Choices<Borders>{{"make-level", Borders::MAKE_LEVEL}, {"level", Borders::LEVEL}},
             "Change the field next to borders, so that each is a level and an extremum "
             "(make-level, the default), or refuse a field where one is not (level)");
  command->add_flag("--cut-open", options.cut.is_cut_open, "Cut the mesh open along the curves");
  command->add_flag("--large", options.is_large_accepted,
                    "Cut even if the cut mesh has more than 50 times as many triangles, as for noise on many handles; "
                    "their number is printed first");
  begin_group(*command, "Output");
  add_file(
    *command, "--curves", options.curves_path,
    "Write the curves to this file, .polylines.txt or .csv; for levels also .vtp, .obj, and .json, which have the "
    "arc, value, and length of each, and whether it is closed");
  add_file(
    *command, "--cut-mesh", options.cut_mesh_path,
    "Write the cut mesh to this file, .off, .ply, .obj, .stl, or .vtp. PLY and VTP have the patch of each face, also "
    "as its color, and keep the fields of the vertices of such a file, or of another one of VTK");
  add_file(*command, "--patches", options.patches_path,
           "Write the number of the patch of each face of the cut mesh to this file, one per line");
  add_file(*command, "--pieces", options.pieces_path,
           "Write the triangles of each patch N to a file piece_N.ply in this folder");
  add_file(
    *command, "--vertex-map", options.vertex_map_path,
    "For disks: write the number, from 0, of the vertex of the input that each vertex of the cut mesh is a copy of "
    "to this file, one per line; PLY has it as property original");
  add_graph_file(*command, options.graph_path);
  add_page_options(*command, options);
  add_file(*command, "--mesh-out", options.mesh_path,
           "Write the cut mesh to this file as --cut-mesh does, but with the value, the arc, and the "
           "node of each vertex in the place of other properties");
  add_json_option(*command, options.is_report_json);
  add_example(*command, "reeb_graph curves scan.ply --type pants --html page.html");
  command->callback(
    [&options] { run_with_threads(options.graph.number_of_threads, [&options] { run_curves(options); }); });
}

void add_field_command(CLI::App& app, Command_options& options)
{
  CLI::App* command = app.add_subcommand("field", "Write a scalar field, one number per line");
  add_input_options(*command, options.input);
  add_list_of_fields(*command, "--type", computed_fields);
  command->add_option("--type", options.input.field, "The field, one of the list at the end")
    ->check(CLI::IsMember(names_of_computed_fields))
    ->required();
  add_choice(*command, "--unreached", options.input.is_unreached_left, Choices<bool>{{"error", false}, {"nan", true}},
             "What the vertices of components are without a vertex of --source, or of --min and --max: an error, the "
             "default, or NaN");
  add_threads_option(*command, options.number_of_threads);
  begin_group(*command, "Output");
  add_output_files(*command, options.output_paths, "Write the field to these files; .npy for NumPy")->required();
  add_json_option(*command, options.is_report_json);
  add_example(*command, "reeb_graph field scan.ply --type harmonic --output harmonic.txt");
  command->callback([&options] { run_with_threads(options.number_of_threads, [&options] { run_field(options); }); });
}

void add_handles_command(CLI::App& app, Handles_options& options)
{
  CLI::App* command = app.add_subcommand("handles", "Find handles and tunnels, each by a short loop around it");
  add_input_options(*command, options.input);
  add_field_option(*command, options.input, "; by default the coordinate x, y, or z that is least noisy");
  add_strict_option(*command, options.input);
  begin_group(*command, "Removal");
  command->add_option_function<std::string>(
    "--remove-below", [&options](const std::string& text) { options.size_to_remove = parse_size(text); },
    "Remove the handles and tunnels with a loop shorter than this: X in units of length, or P% of the diagonal of the "
    "box of the mesh");
  add_whole_number(*command, "--remove", options.number_to_remove, "Remove at most this many, the smallest first");
  begin_group(*command, "Output");
  add_file(*command, "--loops", options.loops_path,
           "Write the loops, after the removal, to this file, .vtp, .obj, or .polylines.txt");
  command->add_flag_callback(
    "--no-shortening", [&options] { options.are_loops_shortened = false; }, "Do not shorten the loops");
  command->add_flag("--ignore-self-intersections", options.are_self_intersections_ignored,
                    "Tell handles from tunnels where triangles intersect too; it is not certain there");
  add_output_files(*command, options.output_paths,
                   "Write the mesh after the removal to these files, .off, .ply, .obj, .stl, or .vtp; without a "
                   "removal, write the loops, as --loops does");
  add_page_options(*command, options, "the graph and the loops on the surface", "the field, for the page");
  add_threads_option(*command, options.number_of_threads);
  add_json_option(*command, options.is_report_json);
  add_example(*command, "reeb_graph handles scan.ply --remove-below 5% --output clean.ply");
  command->callback([&options] { run_with_threads(options.number_of_threads, [&options] { run_handles(options); }); });
}

void add_repair_command(CLI::App& app, Repair_command_options& options)
{
  CLI::App* command = app.add_subcommand("repair", "Make an oriented manifold surface of a mesh, or of tetrahedra");
  begin_group(*command, "Input");
  add_mesh_file(*command, options.input);
  begin_group(*command, "Repair, in this order");
  Repair_options& repair = options.repair;
  CLI::Option* merge = command->add_flag("--merge", repair.are_coinciding_points_merged,
                                         "Merge points that coincide, unless an edge would get more than two faces, or "
                                         "a point several fans of faces");
  add_real_number(*command, "--merge-within", repair.distance,
                  "Merge points of border edges that are at most so far from each other, in units of length, as "
                  "MeshLab's Merge Close Vertices and admesh's --tolerance do: each joins the nearest one before it in "
                  "the file that has joined none")
    ->excludes(merge);
  command->add_option_function<std::string>(
    "--stitch", [&repair](const std::string& text) { repair.stitching = parse_size(text); },
    "Join borders, also at T-junctions: merge points of borders, and cut edges of borders at points of borders, that "
    "are at "
    "most so far from each other. X in units of length, or P% of the diagonal of the box of the mesh");
  command->add_flag("--cancel-opposite", repair.are_opposite_faces_cancelled,
                    "Cancel faces with the same corners the other way round, one by one; of a sheet that is listed on "
                    "both sides, one stays");
  command->add_flag("--split", repair.is_split,
                    "Pair faces at edges with more than two, and cut the mesh open at those that are left, at vertices "
                    "whose faces form several fans, and where no orientation agrees");
  command->add_flag(
    "--orient", repair.are_faces_oriented,
    "Reverse faces so that neighbors agree, and turn solids that are inside out, with what lies in them");
  add_real_number(*command, "--least-piece", repair.least_share,
                  "Leave out components with less than this share of the area, 0.01 for a hundredth, and closed ones "
                  "that have no inside");
  add_whole_number(*command, "--fill", repair.most_filled_edges, "Fill borders of at most so many edges");
  command->add_flag("--largest", repair.is_largest_kept, "Keep the component with the most faces only");
  command->add_flag("--unused", repair.are_unused_points_left_out, "Leave out points of no face");
  command->add_flag_callback(
    "--all",
    [&repair] {
      repair.are_coinciding_points_merged = repair.are_opposite_faces_cancelled = true;
      repair.is_split = repair.are_faces_oriented = repair.are_unused_points_left_out = true;
    },
    "The same as --merge --cancel-opposite --split --orient --unused");
  begin_group(*command, "Output");
  add_output_files(
    *command, options.output_paths,
    "Write the mesh to these files, .off, .ply, .obj, .stl, or .vtp. PLY and VTP keep the fields of the vertices; a "
    "merged vertex has those of the one with the lowest number")
    ->required();
  add_file(*command, "--map", options.map_path,
           "Write the new number of each vertex of MESH to this file, one per line, -1 if it is left out");
  add_json_option(*command, options.is_report_json);
  add_example(*command, "reeb_graph repair scan.stl --all --output closed.ply");
  command->callback([&options] { run_with_threads(0, [&options] { run_repair(options); }); });
}

CLI::ValidationError no_place(const std::string& option, const std::string& text)
{
  return CLI::ValidationError(option,
                              quote(text) + " is none of "
                                + (option == "--root" ? "tip, thickest, and a vertex by its number"
                                                      : "a vertex by its number, a point X,Y,Z, thickest, and tips"));
}

Skeleton_place parse_place(const std::string& option, const std::string& text)
{
  if(text == "thickest")
    return {Skeleton_place::THICKEST};
  if(text == "tips")
    return {Skeleton_place::TIPS};
  if(text.find_first_not_of("-0123456789") == std::string::npos)
    return {Skeleton_place::VERTEX, parse_whole_number(option, text, {})};
  std::vector<double> numbers;
  std::istringstream words(text + ',');
  for(std::string word; std::getline(words, word, ',');)
    numbers.push_back(text.find(',') == std::string::npos ? 0 : parse_real_number(option, word));
  if(numbers.size() != 3 || !std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
    throw no_place(option, text);
  return {Skeleton_place::POINT, 0, Point(numbers[0], numbers[1], numbers[2])};
}

void add_skeleton_places(CLI::App& command, Skeleton_command_options& options)
{
  for(const auto& [name, places, description] :
      {std::make_tuple("--from", &options.from,
                       "Write the shortest paths along the skeleton from here, in place of the arcs, to .vtp or "
                       ".polylines.txt: a vertex of the mesh by its number, a point X,Y,Z, thickest, or tips; can be "
                       "repeated; by default thickest"),
       std::make_tuple("--to", &options.to, "Where these paths lead, given as --from; by default tips")})
  {
    const auto add = [name = std::string(name), places = places](const std::vector<std::string>& texts) {
      for(const std::string& text : texts)
        places->push_back(parse_place(name, text));
    };
    suggest("thickest tips", command.add_option_function<std::vector<std::string>>(name, add, description))
      ->type_name("PLACE")
      ->allow_extra_args(false);
  }
  const auto set_root = [&options](const std::string& text) {
    options.settings.root = text == "tip" ? Skeleton_place() : parse_place("--root", text);
    if(text == "tips" || options.settings.root->kind == Skeleton_place::POINT)
      throw no_place("--root", text);
  };
  suggest("tip thickest",
          command.add_option_function<std::string>(
            "--root", set_root,
            "The roots of SWC's trees: a tip of each, the thickest point, which has type 1 in the largest tree, or, of "
            "one tree, that of a vertex of the mesh"))
    ->type_name("tip|thickest|VERTEX");
  add_choice(command, "--radius", options.swc.are_radii_inscribed, Choices<bool>{{"area", false}, {"inscribed", true}},
             "The radii of SWC: those of circles with the area of contours (area, the default), or the distance from "
             "the surface (inscribed); where one is 0, as at tips, it is that of a point beside it");
  add_whole_number(command, "--swc-type", options.swc.type,
                   "The type of SWC's points but for the soma, from 2 on: 2 axon, 3 dendrite (the default), 4 apical "
                   "dendrite; programs refuse 0",
                   {Swc_options::least_type, Swc_options::largest_type});
}

void add_skeleton_command(CLI::App& app, Skeleton_command_options& options)
{
  CLI::App* command = app.add_subcommand("skeleton", "Extract lines inside, with radii, and a loop for each handle");
  add_input_options(*command, options.input);
  add_field_option(*command, options.input, "; by default the distance from a tip of each component");
  add_strict_option(*command, options.input);
  add_real_number(*command, "--least-piece", options.input.least_share,
                  "Leave out components with less than this share of the area, and those without inside, as by repair");
  begin_group(*command, "Skeleton");
  add_real_number(
    *command, "--pruning-ratio", options.settings.pruning_ratio,
    "Remove branches shorter than this share of their radius, or that stand out from the trunk by less than "
    "this share of its radius, 0.5 by default; "
    "those that lead to borders stay");
  add_real_number(*command, "--sampling-ratio", options.settings.sampling_ratio,
                  "The distance between points, as a share of the radius, 0.5 by default");
  add_real_number(
    *command, "--spacing", options.settings.spacing,
    "The distance between points, in the unit of the mesh, but before the end of a line; by default by the "
    "radius");
  add_real_number(*command, "--smooth", options.settings.smooth,
                  "The price of bends when lines are moved to the middle, 1 by default; 0 leaves them where they are");
  command->add_flag_callback(
    "--fill-borders", [&options] { options.settings.are_borders_ends = false; },
    "Treat borders as if they were filled, so that they are not ends, as for a scan with holes");
  add_skeleton_places(*command, options);
  begin_group(*command, "Output");
  add_output_files(*command, options.output_paths,
                   "Write the skeleton to these files, .swc (trees, in which each loop is cut once), .vtp, "
                   ".polylines.txt, .graphml, or .csv (a line for each branch, with what is measured of it)");
  add_file(*command, "--mesh-out", options.mesh_path,
           "Write the mesh to this file, .ply or .vtp, with numbers of each face: branch; arc, the same, but -1 in "
           "junctions; and junction, 1 in junctions and 0 elsewhere");
  add_file(*command, "--pieces", options.pieces_path,
           "Write the faces of each branch N to a file piece_N.ply in this folder");
  add_page_options(*command, options, "the lines in the surface", "lengths, for the page");
  add_threads_option(*command, options.number_of_threads);
  add_json_option(*command, options.is_report_json);
  add_example(*command, "reeb_graph skeleton neuron.ply --output neuron.swc");
  command->callback([&options] { run_with_threads(options.number_of_threads, [&options] { run_skeleton(options); }); });
}

void add_demo_command(CLI::App& app, Demo_options& options)
{
  CLI::App* command = app.add_subcommand("demo", "Show a Reeb graph of a generated surface; needs no input");
  begin_group(*command, "Output");
  add_file(*command, "--out", options.folder, "The folder for the files")->capture_default_str();
  add_example(*command, "reeb_graph demo --out figure");
  command->callback([&options] { run_demo(options); });
}

// Runs the command, or prints the help that is asked for.
void run_command(CLI::App& app, int argc, char** argv)
{
  try
  {
    app.parse(argc, argv);
  }
  catch(const CLI::Success& request_for_help)
  {
    app.exit(request_for_help);
  }
  flush_standard_output();
}

int report_error(const std::string& message)
{
  std::cerr << "reeb_graph: error: " << message << '\n';
  return EXIT_FAILURE;
}

int run(int argc, char** argv)
{
  CLI::App app("Exact Reeb graphs of scalar fields on triangle meshes", "reeb_graph");
  app.formatter(std::make_shared<Help_formatter>());
  app.require_subcommand(1);
  app.set_version_flag("--version",
                       "reeb_graph " REEB_GRAPH_VERSION " (CGAL " CGAL_VERSION_STR ", " REEB_GRAPH_COMPILER ")");
  Compute_options compute_options;
  Compare_options compare_options;
  Contour_options contour_options;
  Curves_options curves_options;
  Command_options field_options;
  Handles_options handles_options;
  Repair_command_options repair_options;
  Skeleton_command_options skeleton_options;
  Demo_options demo_options;
  app
    .add_option_function<std::string>(
      "--completion",
      [&app](const std::string& shell) {
        write_completion(std::cout, app, shell);
        throw CLI::Success();
      },
      "Print what makes a shell complete commands, options and their values, as in: source <(reeb_graph --completion "
      "bash)")
    ->check(CLI::IsMember({"bash", "zsh", "fish"}))
    ->trigger_on_parse();
  add_compute_command(app, compute_options)->callback([&options = compute_options] {
    run_with_threads(options.graph.number_of_threads, [&options] { run_compute(options); });
  });
  add_compare_command(app, compare_options);
  add_contour_command(app, contour_options);
  add_curves_command(app, curves_options);
  add_field_command(app, field_options);
  add_handles_command(app, handles_options);
  add_repair_command(app, repair_options);
  add_skeleton_command(app, skeleton_options);
  add_demo_command(app, demo_options);
  // Commands that are added later would have it, too.
  app.footer("Options of a command:\n  reeb_graph compute --help\n");
  add_example(app, "reeb_graph compute scan.ply --field z --html page.html");
  try
  {
    run_command(app, argc, argv);
    return EXIT_SUCCESS;
  }
  catch(const CLI::ParseError& error)
  {
    return report_error(describe(app, error));
  }
  catch(const std::exception& error)
  {
    return report_error(message_of(error));
  }
}

} // namespace
} // namespace reeb_graph_program

int main(int argc, char** argv)
{
  std::signal(SIGXFSZ, SIG_IGN); // A file that may not grow is an error, as a full disk is.
  return reeb_graph_program::run(argc, argv);
}
