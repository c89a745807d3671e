// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/graph_output.h"

#include "output/output_file.h"

#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/IO/svg.h>
#include <CGAL/Reeb_graph/internal/drawing/Value_scale.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace reeb_graph_program {
namespace {
namespace fs = std::filesystem;

struct Graph_format
{
  std::string ending;
  bool is_in_space;
  bool has_attributes;
};

const std::vector<Graph_format>& graph_formats()
{
  static const std::vector<Graph_format> formats = {
    {".graphml", false, true}, {".dot", false, false},          {".svg", false, false}, {".vtp", true, true},
    {".obj", true, false},     {".polylines.txt", true, false}, {".json", true, true},  {".csv", true, true}};
  return formats;
}

const Graph_format& format_of(const fs::path& path)
{
  const std::vector<Graph_format>& formats = graph_formats();
  std::vector<std::string> endings;
  for(const Graph_format& format : formats)
    endings.push_back(format.ending);
  const std::string ending = ending_of(path, "a graph", endings);
  return formats[std::find(endings.begin(), endings.end(), ending) - endings.begin()];
}

// X.csv stands for X.nodes.csv and X.arcs.csv.
fs::path table_path(const fs::path& path, const std::string& name)
{
  return fs::path(path).replace_extension("." + name + ".csv");
}

} // namespace

void check_graph_format(const fs::path& path) { format_of(path); }

bool is_format_in_space(const fs::path& path) { return format_of(path).is_in_space; }

bool has_arc_attributes(const fs::path& path) { return format_of(path).has_attributes; }

std::vector<fs::path> graph_files(const fs::path& path)
{
  if(path.extension() == ".csv")
    return {table_path(path, "nodes"), table_path(path, "arcs")};
  return {path};
}

void write_graph(const fs::path& path,
                 const Graph& graph,
                 const Field_label& field_label,
                 const Vertex_numbers& vertex_numbers,
                 const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes)
{
  const std::string ending = format_of(path).ending;
  write_file(path, [&](std::ostream& stream) {
    if(ending == ".graphml")
      CGAL::Reeb_graph::write_graphml(stream, graph, vertex_numbers, CGAL::parameters::arc_attributes(arc_attributes));
    else if(ending == ".svg")
      CGAL::Reeb_graph::write_svg(
        stream, graph,
        CGAL::parameters::field_name(field_label.name).field_unit(field_label.unit).vertex_index_map(vertex_numbers));
    else
      CGAL::Reeb_graph::write_graphviz(stream, graph, vertex_numbers);
  });
}

void write_graph_in_space(const fs::path& path,
                          const Graph& graph,
                          const Embedding& embedding,
                          const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes,
                          const std::function<void(std::ostream&)>& write_json)
{
  const auto attributes = CGAL::parameters::arc_attributes(arc_attributes);
  const std::string ending = format_of(path).ending;
  if(ending == ".csv")
  {
    Output_group tables;
    write_file(table_path(path, "nodes"),
               [&](std::ostream& stream) { CGAL::Reeb_graph::write_nodes_csv(stream, graph, embedding, own_numbers); });
    write_file(table_path(path, "arcs"),
               [&](std::ostream& stream) { CGAL::Reeb_graph::write_arcs_csv(stream, graph, embedding, attributes); });
    return tables.put_in_place();
  }
  write_file(path, [&](std::ostream& stream) {
    if(ending == ".vtp")
      CGAL::Reeb_graph::write_vtp(stream, graph, embedding, own_numbers, attributes);
    else if(ending == ".obj")
      CGAL::Reeb_graph::write_obj(stream, graph, embedding);
    else if(ending == ".json")
      write_json(stream);
    else
      CGAL::Reeb_graph::write_polylines(stream, embedding.arc_polylines);
  });
}

void note_lost_nodes(const fs::path& path, const Graph& graph, std::vector<std::string>& notes)
{
  const auto nodes = CGAL::make_range(vertices(graph));
  const auto number = std::count_if(nodes.begin(), nodes.end(),
                                    [&](auto node) { return in_degree(node, graph) + out_degree(node, graph) == 0; });
  if(number > 0 && format_of(path).ending == ".polylines.txt")
    notes.push_back(path.string()
                    + ": nodes without arcs are left out, as they have no line: " + std::to_string(number));
}

void note_lost_unit(const std::string& unit, bool is_shown, std::vector<std::string>& notes)
{
  if(!unit.empty() && !is_shown)
    notes.emplace_back("the unit is left out: --html and drawings of graphs, .svg, show it");
}

void write_vertex_arcs(const std::filesystem::path& path,
                       const std::vector<std::size_t>& places,
                       std::size_t number_of_nodes)
{
  write_file(path, [&](std::ostream& stream) {
    if(is_npy(path))
      return write_npy(stream, std::vector<std::int64_t>(places.begin(), places.end()));
    CGAL::Reeb_graph::internal::Text_output text(stream);
    for(const std::size_t place : places)
      if(place < number_of_nodes)
        text << "node " << place << '\n';
      else
        text << "arc " << place - number_of_nodes << '\n';
    text.flush();
  });
}

namespace {
using CGAL::Reeb_graph::internal::Text_output;

void write_csv(Text_output& text,
               const Graph& graph,
               const std::vector<Persistence_pair>& pairs,
               const Vertex_numbers& vertex_numbers)
{
  text << "kind,lower_vertex,upper_vertex,lower_value,upper_value,persistence\n";
  for(const Persistence_pair& pair : pairs)
  {
    const auto &lower = graph[pair.lower_node], &upper = graph[pair.upper_node];
    text << to_string(pair.kind) << ',' << get(vertex_numbers, lower.vertex) << ',' << get(vertex_numbers, upper.vertex)
         << ',' << lower.value << ',' << upper.value << ',' << CGAL::Reeb_graph::persistence(graph, pair) << '\n';
  }
}

// What lives in sublevel sets has dimension 0 and is born below; relative classes and loops have dimension 1 and are
// born above.
void write_pers(Text_output& text, const Graph& graph, const std::vector<Persistence_pair>& pairs)
{
  typedef CGAL::Reeb_graph::Persistence_pair_kind Kind;
  text << "# dimension birth death: 0 minimum saddle, 1 maximum saddle, 0 minimum maximum, 1 of a loop\n";
  for(const Persistence_pair& pair : pairs)
  {
    const double lower = graph[pair.lower_node].value, upper = graph[pair.upper_node].value;
    if(pair.kind == Kind::MINIMUM_SADDLE || pair.kind == Kind::MINIMUM_MAXIMUM)
      text << "0 " << lower << ' ' << upper << '\n';
    else
      text << "1 " << upper << ' ' << lower << '\n';
  }
}

} // namespace

void check_pairs_format(const std::filesystem::path& path) { ending_of(path, "pairs", {".csv", ".pers"}); }

void write_pairs(const std::filesystem::path& path,
                 const Graph& graph,
                 const std::vector<Persistence_pair>& pairs,
                 const Vertex_numbers& vertex_numbers)
{
  check_pairs_format(path);
  write_file(path, [&](std::ostream& stream) {
    Text_output text(stream);
    if(path.extension() != ".pers")
      write_csv(text, graph, pairs, vertex_numbers);
    else
      write_pers(text, graph, pairs);
    text.flush();
  });
}

namespace {
typedef CGAL::Reeb_graph::Persistence_pair_kind Kind;

constexpr double size = 480, left = 80, top = 30, bottom = 60, right = 30; // of the square, and around it, in pixels

// A kind of pairs as it is drawn: colours that differ for all eyes, and shapes that differ as well.
struct Style
{
  Kind kind;
  const char* name;
  const char* shape; // a path around the point
  const char* colour;
};

constexpr std::array<Style, 4> styles = {
  {{Kind::MINIMUM_SADDLE, "minimum, saddle", "m-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z", "#0072b2"},
   {Kind::SADDLE_MAXIMUM, "saddle, maximum", "m-3.5-3.5h7v7h-7z", "#d55e00"},
   {Kind::MINIMUM_MAXIMUM, "minimum, maximum", "m0-5.5l5.5 5.5l-5.5 5.5l-5.5-5.5z", "#000000"},
   {Kind::LOOP, "loop", "m0-5l5 8.5h-10z", "#009e73"}}};

// The values that the axes show, and where.
class Scale
{
public:
  Scale(const Graph& graph, const std::vector<Persistence_pair>& pairs)
  {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for(const Persistence_pair& pair : pairs)
      for(const double value : {graph[pair.lower_node].value, graph[pair.upper_node].value})
        if(std::isfinite(value))
        {
          lowest = (std::min)(lowest, value);
          highest = (std::max)(highest, value);
        }
    // halves, as the range of finite values can be too large for a number
    const double centre = lowest <= highest ? lowest / 2 + highest / 2 : 0;
    const double half = lowest < highest ? 1.05 * (highest / 2 - lowest / 2) : (std::max)(1., std::abs(centre) / 2);
    lowest_ = centre - half;
    highest_ = centre + half;
    if(!std::isfinite(highest_ - lowest_))
      throw std::runtime_error("the values of the field are too large for a diagram");
  }

  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  double x(double value) const { return left + size * (value - lowest_) / (highest_ - lowest_); }
  double y(double value) const { return top + size - size * (value - lowest_) / (highest_ - lowest_); }

  std::vector<double> ticks() const { return CGAL::Reeb_graph::internal::round_ticks(lowest_, highest_, 4); }

private:
  double lowest_ = 0, highest_ = 1;
};

void write_text(std::ostream& stream, double x, double y, const std::string& anchor, const std::string& text)
{
  stream << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">" << text << "</text>\n";
}

std::string short_number(double number)
{
  std::ostringstream stream;
  stream.precision(4);
  stream << number;
  return stream.str();
}

void write_axes(std::ostream& stream, const Scale& scale)
{
  const double end = left + size, base = top + size;
  for(const double tick : scale.ticks())
  {
    stream << "<path stroke=\"#dddddd\" d=\"M" << scale.x(tick) << ' ' << top << 'V' << base << 'M' << left << ' '
           << scale.y(tick) << 'H' << end << "\"/>\n";
    write_text(stream, scale.x(tick), base + 18, "middle", short_number(tick));
    write_text(stream, left - 8, scale.y(tick) + 4, "end", short_number(tick));
  }
  stream << "<path stroke=\"#888888\" d=\"M" << left << ' ' << base << 'L' << end << ' ' << top << "\"/>\n"
         << "<rect fill=\"none\" stroke=\"black\" x=\"" << left << "\" y=\"" << top << "\" width=\"" << size
         << "\" height=\"" << size << "\"/>\n";
  write_text(stream, left + size / 2, base + 42, "middle", "value of the lower node");
  stream << "<text text-anchor=\"middle\" transform=\"translate(20 " << top + size / 2
         << ") rotate(-90)\">value of the upper node</text>\n";
}

// The band of what is below the threshold, between the diagonal and a line above it.
void write_band(std::ostream& stream, const Scale& scale, double threshold)
{
  const double height = (std::min)(scale.lowest() + threshold, scale.highest());
  stream << "<path fill=\"#eeeeee\" d=\"M" << scale.x(scale.lowest()) << ' ' << scale.y(scale.lowest()) << 'V'
         << scale.y(height) << 'L' << scale.x(scale.highest() - (height - scale.lowest())) << ' '
         << scale.y(scale.highest()) << 'H' << scale.x(scale.highest()) << "z\"/>\n";
}

// Points at the same place, to a tenth of a pixel, are drawn once.
void write_points(std::ostream& stream,
                  const Graph& graph,
                  const std::vector<Persistence_pair>& pairs,
                  const Scale& scale,
                  const Style& style)
{
  std::set<std::pair<long, long>> places;
  stream << "<g fill=\"" << style.colour << "\" fill-opacity=\"0.7\">\n";
  for(const Persistence_pair& pair : pairs)
  {
    const double x = scale.x(graph[pair.lower_node].value), y = scale.y(graph[pair.upper_node].value);
    if(pair.kind != style.kind || !std::isfinite(x) || !std::isfinite(y))
      continue;
    const auto [place, is_new] = places.emplace(std::lround(10 * x), std::lround(10 * y));
    if(is_new)
      stream << "<path d=\"M" << static_cast<double>(place->first) / 10 << ' '
             << static_cast<double>(place->second) / 10 << style.shape << "\"/>\n";
  }
  stream << "</g>\n";
}

// The numbers of the two nodes beside each pair that stays, the most persistent ones first, where there is room.
void write_labels(std::ostream& stream,
                  const Graph& graph,
                  const std::vector<Persistence_pair>& pairs,
                  const Scale& scale,
                  double threshold)
{
  constexpr double text_size = 12, digit_width = 0.62 * text_size;
  constexpr std::size_t most_labels = 40;
  std::vector<std::pair<double, std::size_t>> order;
  for(std::size_t i = 0; i != pairs.size(); ++i)
  {
    const double persistence = CGAL::Reeb_graph::persistence(graph, pairs[i]);
    if(std::isfinite(persistence) && persistence > 0
       && (persistence >= threshold || pairs[i].kind == Kind::MINIMUM_MAXIMUM))
      order.emplace_back(-persistence, i);
  }
  std::sort(order.begin(), order.end());
  order.resize((std::min)(order.size(), most_labels));
  typedef std::array<double, 4> Text_box; // left, top, right, bottom
  std::vector<Text_box> occupied;
  for(const Persistence_pair& pair : pairs) // the points themselves
  {
    const double x = scale.x(graph[pair.lower_node].value), y = scale.y(graph[pair.upper_node].value);
    occupied.push_back({x - 4, y - 4, x + 4, y + 4});
  }
  const auto is_free = [&](const Text_box& box) {
    return box[0] > left && box[2] < left + size && box[1] > top && box[3] < top + size
        && std::none_of(occupied.begin(), occupied.end(), [&](const Text_box& other) {
             return box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3];
           });
  };
  stream << "<g id=\"labels\">\n";
  for(const auto& [negative, i] : order)
  {
    const std::string text = "n" + std::to_string(pairs[i].lower_node) + ", n" + std::to_string(pairs[i].upper_node);
    const double x = scale.x(graph[pairs[i].lower_node].value), y = scale.y(graph[pairs[i].upper_node].value);
    const double length = digit_width * static_cast<double>(text.size());
    for(const double dy : {0., -12., 12., -24., 24.})
    {
      const bool is_right = is_free({x + 8, y + dy - 6, x + 8 + length, y + dy + 6});
      if(!is_right && !is_free({x - 8 - length, y + dy - 6, x - 8, y + dy + 6}))
        continue;
      const double begin = is_right ? x + 8 : x - 8 - length;
      occupied.push_back({begin, y + dy - 6, begin + length, y + dy + 6});
      write_text(stream, is_right ? x + 8 : x - 8, y + dy + 4, is_right ? "start" : "end", text);
      break;
    }
  }
  stream << "</g>\n";
}

// The legend, below the diagonal, where there are no points: each kind that there is, with the number of its pairs.
void write_legend(std::ostream& stream, const std::vector<Persistence_pair>& pairs)
{
  std::ostringstream entries;
  double y = top + size - 16;
  for(auto style = styles.rbegin(); style != styles.rend(); ++style)
  {
    const auto number =
      std::count_if(pairs.begin(), pairs.end(), [&](const Persistence_pair& pair) { return pair.kind == style->kind; });
    if(number == 0)
      continue;
    entries << "<path fill=\"" << style->colour << "\" d=\"M" << left + size - 190 << ' ' << y - 4 << style->shape
            << "\"/>\n";
    write_text(entries, left + size - 178, y, "start", std::string(style->name) + " (" + std::to_string(number) + ")");
    y -= 20;
  }
  stream << "<rect fill=\"white\" x=\"" << left + size - 202 << "\" y=\"" << y + 4 << "\" width=\"198\" height=\""
         << top + size - 8 - y << "\"/>\n"
         << entries.str();
}

} // namespace

void check_diagram_format(const std::filesystem::path& path) { ending_of(path, "a diagram", {".svg"}); }

void write_diagram(const std::filesystem::path& path,
                   const Graph& graph,
                   const std::vector<Persistence_pair>& pairs,
                   std::optional<double> threshold)
{
  check_diagram_format(path);
  const Scale scale(graph, pairs);
  const double width = left + size + right, height = top + size + bottom;
  write_file(path, [&](std::ostream& stream) {
    stream << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
           << "\" font-family=\"sans-serif\" font-size=\"12\">\n<title>Persistence diagram</title>\n"
           << "<rect fill=\"white\" width=\"" << width << "\" height=\"" << height << "\"/>\n";
    if(threshold)
      write_band(stream, scale, *threshold);
    write_axes(stream, scale);
    for(const Style& style : styles)
      write_points(stream, graph, pairs, scale, style);
    write_labels(stream, graph, pairs, scale, threshold.value_or(0));
    write_legend(stream, pairs);
    stream << "</svg>\n";
  });
}

} // namespace reeb_graph_program
