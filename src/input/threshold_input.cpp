// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/threshold_input.h"

#include "input/text_input.h"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace reeb_graph_program {
namespace {
// A finite number, or one with a percent sign, perhaps behind a space.
bool read_number_or_percentage(std::string_view text, Threshold& threshold)
{
  threshold.is_percentage = !text.empty() && text.back() == '%';
  text.remove_suffix(threshold.is_percentage ? 1 : 0);
  text.remove_suffix(threshold.is_percentage && !text.empty() && text.back() == ' ' ? 1 : 0);
  return parse_number(text, threshold.number) == std::errc() && std::isfinite(threshold.number);
}

} // namespace

Threshold parse_size(const std::string& text)
{
  Threshold threshold;
  if(!read_number_or_percentage(text, threshold))
    throw std::runtime_error("the size '" + text + "' is neither a number nor a percentage: as 0.5 or 5%");
  if(threshold.number < 0)
    throw std::runtime_error("the size '" + text + "' is negative");
  return threshold;
}

Threshold parse_threshold(const std::string& text)
{
  Threshold threshold;
  threshold.is_suggested = text == "auto";
  if(threshold.is_suggested)
    return threshold;
  if(!read_number_or_percentage(text, threshold))
    throw std::runtime_error("the threshold '" + text
                             + "' is neither a number, nor a percentage, nor auto: as 0.5 or 5%");
  if(threshold.number < 0)
    throw std::runtime_error("the threshold '" + text + "' is negative");
  if(threshold.is_percentage && threshold.number > 100)
    throw std::runtime_error("the threshold '" + text + "' is more than the whole range of the field");
  return threshold;
}

} // namespace reeb_graph_program
