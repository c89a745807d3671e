// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_IO_TEXT_H
#define CGAL_REEB_GRAPH_INTERNAL_IO_TEXT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#if !defined(__cpp_lib_to_chars) && __has_include(<fast_float/fast_float.h>)
#include <fast_float/fast_float.h>
#define CGAL_REEB_GRAPH_HAS_FAST_FLOAT
#endif

// Requirements of functions that read and write graphs on the types of their arguments.

namespace CGAL::Reeb_graph::internal {

// ---- Values as texts: by the operators of streams, or else as the numbers that the traits class makes of them.

template <class Scalar>
using Written_scalar = decltype(std::declval<std::ostream&>() << std::declval<const Scalar&>());
template <class Scalar>
using Read_scalar = decltype(std::declval<std::istream&>() >> std::declval<Scalar&>());

template <class Traits>
struct Scalars_can_be_written
  : std::disjunction<Has<Written_scalar, typename Traits::Scalar>, Has<Scalar_to_double, Traits>>
{
  static_assert(Scalars_can_be_written::value,
                "The scalar values cannot be written: give their type an operator<<, or pass as named parameter "
                "geom_traits a traits class with a member scalar_to_double_object() that makes numbers of them.");
};

template <class Traits>
struct Scalars_can_be_read
  : std::disjunction<Has<Read_scalar, typename Traits::Scalar>, Has<Scalar_from_double, Traits>>
{
  static_assert(Scalars_can_be_read::value,
                "The scalar values cannot be read: give their type an operator>>, or pass as named parameter "
                "geom_traits a traits class with a member scalar_from_double_object() that makes them of numbers.");
};

// A graph and a map of the vertices of its mesh, for functions that see no mesh.
template <class Graph, class Map>
struct Keys_are_vertices_of_nodes : Has_key<Map, Vertex_of_node<Graph>>
{
  static_assert(Keys_are_vertices_of_nodes::value,
                "The keys of this index map are not the vertices of the mesh that the graph is of: its key_type has "
                "to be their descriptor.");
};

template <class Graph, class Map>
using Graph_and_vertex_map =
  std::conjunction<Augmented_reeb_graph<Graph>, Map_is_property_map<Map>, Keys_are_vertices_of_nodes<Graph, Map>>;

// The text with the replacement character for each byte that is no part of a character in UTF-8.
inline std::string to_utf8(std::string_view text)
{
  std::string result;
  for(auto byte = text.begin(), next = byte; byte != text.end(); byte = next)
  {
    const auto character = boost::locale::utf::utf_traits<char>::decode(next, text.end());
    if(boost::locale::utf::is_valid_codepoint(character) && (character | 1) != 0xFFFF)
      result.append(byte, next);
    else
    {
      result += "\xEF\xBF\xBD";
      next = byte + 1;
    }
  }
  return result;
}

// The text in UTF-8, with spaces for the control characters that XML does not allow; entities are left to the caller.
inline std::string xml_characters(const std::string& text)
{
  std::string result = to_utf8(text);
  for(char& c : result)
    if(static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
      c = ' ';
  return result;
}

// Text as XML has it.
inline std::string escape_xml(const std::string& text)
{
  std::string escaped;
  for(const char c : xml_characters(text))
  {
    switch(c)
    {
    case '&': escaped += "&amp;"; break;
    case '<': escaped += "&lt;"; break;
    case '>': escaped += "&gt;"; break;
    case '"': escaped += "&quot;"; break;
    default: escaped += c;
    }
  }
  return escaped;
}

// Whether std::to_chars() writes such numbers.
template <class Value>
#ifdef __cpp_lib_to_chars
constexpr bool is_written_by_to_chars = std::is_same_v<Value, double> || std::is_same_v<Value, float>;
#else
constexpr bool is_written_by_to_chars = false;
#endif

// A sign, 17 digits, a point, and an exponent.
constexpr std::size_t most_characters_of_number = 32;

template <class Value>
char* write_with_precision(const Value& value, int precision, char* out)
{
  return std::to_chars(out, out + most_characters_of_number, value, std::chars_format::general, precision).ptr;
}

template <class Value>
std::string to_string_with_precision(const Value& value, int precision)
{
  if constexpr(is_written_by_to_chars<Value>)
  {
    char digits[most_characters_of_number];
    if(precision <= std::numeric_limits<double>::max_digits10)
      return {digits, write_with_precision(value, precision, digits)};
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(precision);
  if constexpr(std::is_integral_v<Value>)
    text << +value; // those of 8 bits are no characters
  else
    text << value;
  return text.str();
}

// Six digits: what a person reads.
template <class Value>
std::string to_short_string(const Value& value)
{
  return to_string_with_precision(value, 6);
}

// As many digits as it takes to read back the same floating-point number.
template <class Value>
std::string to_round_trip_string(const Value& value)
{
  if constexpr(std::is_floating_point_v<Value>)
    return to_string_with_precision(value, std::numeric_limits<Value>::max_digits10);
  else
    return to_short_string(value);
}

// The text of a scalar value: itself, or its number if it has no operator<<.
template <class Traits>
auto written_scalar(const Scalar_conversion<Traits>& conversion, const typename Traits::Scalar& value)
{
  if constexpr(Has<Written_scalar, typename Traits::Scalar>::value)
    return value;
  else
    return conversion.to_double(value);
}

// JSON has no numbers that are infinite or NaN.
inline std::string json_of(double number) { return std::isfinite(number) ? to_round_trip_string(number) : "null"; }

inline std::string json_of(std::int64_t number) { return std::to_string(number); }

inline std::string json_of(const std::string& text)
{
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "\"";
  for(const char c : to_utf8(text))
  {
    const auto code = static_cast<unsigned char>(c);
    if(code < 32)
      result += std::string("\\u00") + digits[code / 16] + digits[code % 16];
    else
      result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return result + '"';
}

template <class Range, class JsonOfElement>
std::string json_list(const Range& range, const JsonOfElement& json_of_element)
{
  std::string result = "[";
  for(const auto& element : range)
    result += (result.size() == 1 ? "" : ", ") + json_of_element(element);
  return result + "]";
}

template <class Point>
std::string json_of_point(const Point& point)
{
  return json_list(coordinates_of(point), [](double number) { return json_of(number); });
}

// The pieces of a chain as paths of vertices. `ends_of` returns the two vertices of a halfedge by their indices.
template <class Chain, class EndsOf>
std::string json_of_chain(const Chain& chain, const EndsOf& ends_of)
{
  std::string result = "[";
  for(std::size_t i = 0; i != chain.size(); ++i)
  {
    const auto [source, target] = ends_of(chain[i]);
    const bool is_first = i == 0 || ends_of(chain[i - 1]).second != source;
    if(is_first)
      result += (i == 0 ? "[" : "], [") + std::to_string(source);
    result += ", " + std::to_string(target);
  }
  return result + (chain.size() == 0 ? "]" : "]]");
}

// Text that goes to a stream in large pieces. A stream takes longer to find its place and its locale for each piece
// than it takes to write it.
class Text_output
{
public:
  explicit Text_output(std::ostream& out) : out_(out) {}

  Text_output(const Text_output&) = delete;
  Text_output& operator=(const Text_output&) = delete;

  Text_output& operator<<(std::string_view text)
  {
    piece_ += text;
    if(piece_.size() >= size_of_piece)
      flush();
    return *this;
  }

  Text_output& operator<<(char c) { return *this << std::string_view(&c, 1); }

  // Writes what to_round_trip_string() makes of the number.
  template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
  Text_output& operator<<(Number number)
  {
    char digits[most_characters_of_number];
    char* end = digits;
    if constexpr(is_written_by_to_chars<Number>)
      end = write_with_precision(number, std::numeric_limits<Number>::max_digits10, digits);
    else if constexpr(std::is_integral_v<Number> && sizeof(Number) > 1)
      end = std::to_chars(digits, digits + most_characters_of_number, number).ptr;
    else
      return *this << to_round_trip_string(number);
    return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
  }

  // Writes what is left. It is not left to a destructor, in which a stream could throw an exception.
  void flush()
  {
    out_.write(piece_.data(), static_cast<std::streamsize>(piece_.size()));
    piece_.clear();
  }

private:
  static constexpr std::size_t size_of_piece = 1 << 16;

  std::ostream& out_;
  std::string piece_;
};

// Lets a stream write numbers as programs read them, whatever its locale is before and after. A stream that has failed
// keeps this locale: to set another one on a full disk would break its buffer, which then throws std::bad_cast.
class Classic_locale
{
public:
  explicit Classic_locale(std::ostream& out) : out_(out), before_(out.getloc())
  {
    if(out.flush())
      out.imbue(std::locale::classic());
  }
  ~Classic_locale()
  {
    try
    {
      if(out_.flush())
        out_.imbue(before_);
    }
    catch(...) // The state of the stream tells it, too.
    {}
  }
  Classic_locale(const Classic_locale&) = delete;
  Classic_locale& operator=(const Classic_locale&) = delete;

private:
  std::ostream& out_;
  std::locale before_;
};

// The attributes of a named parameter, which have to be as many as things.
template <class Parameter>
std::vector<Attribute> checked_attributes(const Parameter& parameter, std::size_t size)
{
  std::vector<Attribute> attributes = parameters::choose_parameter(parameter, std::vector<Attribute>());
  for(const Attribute& attribute : attributes)
  {
    const std::size_t given = std::visit([](const auto& numbers) { return numbers.size(); }, attribute.numbers);
    if(given != size)
      throw Attribute_count_error(attribute.name, given, size);
  }
  return attributes;
}

// Where functions write to: a stream, or the file of a name. It is no template parameter of theirs, so that functions of
// the same names that take a stream, as Boost has one, are preferred for what is derived from it.
class Output
{
public:
  Output(std::ostream& stream) : stream_(&stream) {}
  template <class Name, class = std::enable_if_t<std::is_convertible_v<const Name&, std::string>>>
  Output(const Name& filename) : filename_(filename)
  {}

  // Calls write(stream). The error says why a file cannot be written, where the system does.
  template <class Write>
  void operator()(const Write& write) const
  {
    if(stream_ != nullptr)
      return write(*stream_);
    errno = 0;
    std::ofstream out(filename_);
    if(out)
      write(out);
    out.close();
    if(!out)
      throw File_error(filename_ + " cannot be written"
                       + (errno == 0 ? "" : ": " + std::generic_category().message(errno)));
  }

private:
  std::ostream* stream_ = nullptr;
  std::string filename_;
};

// How many characters at the beginning of a text are a number with a point and an exponent, after a sign; 0 if none are.
inline std::size_t size_of_decimal_number(std::string_view text)
{
  const auto skip_digits = [&](std::size_t i) {
    while(i < text.size() && text[i] >= '0' && text[i] <= '9')
      ++i;
    return i;
  };
  const std::size_t begin = !text.empty() && text[0] == '-' ? 1 : 0;
  std::size_t end = skip_digits(begin), digits = end - begin;
  if(end < text.size() && text[end] == '.')
  {
    const std::size_t end_of_fraction = skip_digits(end + 1);
    digits += end_of_fraction - end - 1;
    end = digits == 0 ? begin : end_of_fraction;
  }
  if(digits == 0)
    return 0;
  if(end < text.size() && (text[end] == 'e' || text[end] == 'E'))
  {
    const bool is_signed = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
    const std::size_t exponent = end + (is_signed ? 2 : 1), end_of_exponent = skip_digits(exponent);
    end = end_of_exponent == exponent ? end : end_of_exponent;
  }
  return end;
}

// How many characters at the beginning of a text are this word, in small letters, or in capitals.
inline std::size_t size_of_word(std::string_view text, std::string_view word)
{
  for(std::size_t i = 0; i != word.size(); ++i)
    if(i == text.size() || (text[i] != word[i] && text[i] != word[i] - 'a' + 'A'))
      return 0;
  return word.size();
}

// The value of a decimal number: by fast_float if it is there, as a stream takes fifteen times as long. Whether it is one.
template <class Number>
bool read_decimal_number(std::string_view text, Number& value)
{
#ifdef CGAL_REEB_GRAPH_HAS_FAST_FLOAT
  const auto result = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() && value <= (std::numeric_limits<Number>::max)()
      && value >= std::numeric_limits<Number>::lowest();
#else
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  stream >> value;
  return !stream.fail();
#endif
}

// Does what std::from_chars() does for floating-point numbers.
template <class Number>
std::from_chars_result read_floating_number(const char* begin, const char* end, Number& number)
{
  const std::string_view text(begin, static_cast<std::size_t>(end - begin));
  if(const std::size_t size = size_of_decimal_number(text))
  {
    Number value = 0;
    const bool is_read = read_decimal_number(text.substr(0, size), value);
    const std::string_view digits = text.substr(0, (std::min)(size, text.find_first_of("eE")));
    const bool is_lost = value == 0 && digits.find_first_of("123456789") != std::string_view::npos;
    if(!is_read || is_lost)
      return {begin + size, std::errc::result_out_of_range};
    number = value;
    return {begin + size, std::errc()};
  }
  const std::size_t sign = !text.empty() && text[0] == '-' ? 1 : 0;
  const std::string_view word = text.substr(sign);
  const std::size_t infinity = (std::max)(size_of_word(word, "infinity"), size_of_word(word, "inf"));
  const std::size_t size = infinity != 0 ? infinity : size_of_word(word, "nan");
  if(size == 0)
    return {begin, std::errc::invalid_argument};
  number = infinity != 0 ? std::numeric_limits<Number>::infinity() : std::numeric_limits<Number>::quiet_NaN();
  number = sign == 1 ? -number : number;
  return {begin + sign + size, std::errc()};
}

// std::from_chars(). Standard libraries before that of g++ 11, and that of clang, have it for whole numbers alone.
template <class Number>
std::from_chars_result read_number(const char* begin, const char* end, Number& number)
{
#ifdef __cpp_lib_to_chars
  return std::from_chars(begin, end, number);
#else
  if constexpr(std::is_floating_point_v<Number>)
    return read_floating_number(begin, end, number);
  else
    return std::from_chars(begin, end, number);
#endif
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_IO_TEXT_H
