// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

// Writes a large closed surface of genus 3, for ranks of MPI, as a binary .ply or as a .raw file: a plate with square
// holes, meshed by a lattice, twice, where the upper and the lower side share the vertices on the border.
namespace {
constexpr std::int64_t holes = 3;

struct Plate
{
  explicit Plate(std::int64_t triangles)
    : side(std::max<std::int64_t>(2, std::llround(std::sqrt(static_cast<double>(triangles) / 4 / (5 * holes + 3))))),
      width(side * (2 * holes + 1)),
      height(3 * side)
  {}

  bool is_cell(std::int64_t x, std::int64_t y) const
  {
    return x >= 0 && y >= 0 && x < width && y < height && !(y >= side && y < 2 * side && x / side % 2 == 1);
  }
  int number_of_cells_around(std::int64_t x, std::int64_t y) const
  {
    return is_cell(x - 1, y - 1) + is_cell(x, y - 1) + is_cell(x - 1, y) + is_cell(x, y);
  }

  std::int64_t side, width, height; // of a hole, or of what is beside it; of the plate
};

// A number between 0 and 1 that depends on the index (the generator splitmix64).
double noise(std::uint64_t index)
{
  std::uint64_t z = (index + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
}

class Output
{
public:
  explicit Output(const std::string& path) : out_(path, std::ios::binary) {}

  template <class Number>
  void put(Number number) // on a little-endian machine
  {
    out_.write(reinterpret_cast<const char*>(&number), sizeof(Number));
  }
  void put(const std::string& text) { out_ << text; }
  bool is_good() { return static_cast<bool>(out_.flush()); }

private:
  std::ofstream out_;
};
} // namespace

int main(int argc, char** argv)
{
  if(argc != 4)
  {
    std::cerr << "usage: write_plate FILE.ply|FILE.raw TRIANGLES smooth|noise\n";
    return EXIT_FAILURE;
  }
  const std::string path = argv[1], field = argv[3];
  const bool is_raw = path.substr(path.size() - 4) == ".raw";
  const Plate plate(std::atoll(argv[2]));
  std::vector<std::uint32_t> upper, lower; // the numbers of the vertices
  std::uint32_t number = 0;
  std::uint64_t number_of_cells = 0;
  for(std::int64_t y = 0; y <= plate.height; ++y)
    for(std::int64_t x = 0; x <= plate.width; ++x)
    {
      const int cells = plate.number_of_cells_around(x, y);
      upper.push_back(cells == 0 ? 0 : number++);
      lower.push_back(cells == 4 ? number++ : upper.back());
      number_of_cells += plate.is_cell(x, y) ? 1 : 0;
    }
  Output out(path);
  if(is_raw)
  {
    out.put(std::string("ReebRaw1"));
    out.put(std::uint64_t(number));
    out.put(std::uint64_t(4 * number_of_cells));
  }
  else
    out.put("ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(number)
            + "\nproperty double x\nproperty double y\nproperty double z\nproperty double " + field + "\nelement face "
            + std::to_string(4 * number_of_cells) + "\nproperty list uchar uint vertex_indices\nend_header\n");
  std::uint64_t index = 0;
  for(std::int64_t row = 0; row <= plate.height; ++row)
    for(std::int64_t column = 0; column <= plate.width; ++column)
    {
      const int cells = plate.number_of_cells_around(column, row);
      const double unit = 2. * static_cast<double>(plate.side);
      const double x = static_cast<double>(column) / unit, y = static_cast<double>(row) / unit;
      for(int k = 0; k != (cells == 0 ? 0 : cells == 4 ? 2 : 1); ++k)
      {
        const double z = cells == 4 ? (0.2 - 0.4 * k) * (1 + 0.3 * std::cos(3 * x)) : 0; // No level is flat.
        const double smooth = std::sin(2 * x) + 0.5 * std::sin(3 * y + x) + 0.1 * z;
        if(!is_raw)
        {
          out.put(x);
          out.put(y);
          out.put(z);
        }
        out.put(field == "noise" ? noise(index++) : smooth);
      }
    }
  const auto put_triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if(!is_raw)
      out.put(std::uint8_t(3));
    for(const std::uint32_t v : {a, b, c})
      if(is_raw)
        out.put(std::uint64_t(v));
      else
        out.put(v);
  };
  for(std::int64_t y = 0; y != plate.height; ++y)
    for(std::int64_t x = 0; x != plate.width; ++x)
    {
      if(!plate.is_cell(x, y))
        continue;
      const std::size_t i = static_cast<std::size_t>(y * (plate.width + 1) + x), above = i + plate.width + 1;
      // The diagonal ends at the corner of the plate, so that it has not both ends on the border.
      const bool is_rising = (2 * x < plate.width) == (2 * y < plate.height);
      for(const auto* side : {&upper, &lower})
      {
        std::uint32_t a = (*side)[i], b = (*side)[i + 1], c = (*side)[above + 1], d = (*side)[above];
        if(side == &lower)
          std::swap(b, d);
        if(is_rising)
        {
          put_triangle(a, b, c);
          put_triangle(a, c, d);
        }
        else
        {
          put_triangle(a, b, d);
          put_triangle(b, c, d);
        }
      }
    }
  return out.is_good() ? EXIT_SUCCESS : EXIT_FAILURE;
}
