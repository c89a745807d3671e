// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_ARRAYS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_ARRAYS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>

#include <boost/config.hpp>

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The memory of a Plain_vector, whose functions are compiled once for elements of all types. They are not inlined, as
// each call of them takes longer than a call does.
class Plain_storage
{
protected:
  Plain_storage() = default;
  Plain_storage(const Plain_storage&) = delete;
  Plain_storage& operator=(const Plain_storage&) = delete;
  ~Plain_storage() { ::operator delete(place_); }

  void swap(Plain_storage& other) noexcept
  {
    std::swap(place_, other.place_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  BOOST_NOINLINE void reserve(std::size_t capacity, std::size_t size_of_element)
  {
    if(capacity <= capacity_)
      return;
    if(capacity > (std::numeric_limits<std::ptrdiff_t>::max)() / size_of_element)
      throw std::bad_array_new_length();
    void* const place = ::operator new(capacity* size_of_element);
    if(size_ != 0)
      std::memcpy(place, place_, size_ * size_of_element);
    ::operator delete(place_);
    place_ = place;
    capacity_ = capacity;
  }

  // Makes room for more elements, so that to add one after the other takes constant time each.
  BOOST_NOINLINE void grow(std::size_t number, std::size_t size_of_element)
  {
    if(size_ + number > capacity_)
      reserve(size_ + (std::max)(size_, number), size_of_element);
  }

  BOOST_NOINLINE void append(const void* first, std::size_t number, std::size_t size_of_element)
  {
    if(number == 0)
      return;
    grow(number, size_of_element);
    std::memcpy(bytes() + size_ * size_of_element, first, number * size_of_element);
    size_ += number;
  }

  // New elements are copies of one that is somewhere else: of a block of them, so that these stay in the cache.
  BOOST_NOINLINE void resize(std::size_t size, const void* element, std::size_t size_of_element)
  {
    if(size > size_)
    {
      grow(size - size_, size_of_element);
      char* const first = bytes() + size_ * size_of_element;
      const std::size_t all = (size - size_) * size_of_element, block = (std::max)(size_of_element, std::size_t(2048));
      std::memcpy(first, element, size_of_element);
      for(std::size_t done = size_of_element; done != all;)
      {
        const std::size_t next = (std::min)((std::min)(done, block / size_of_element * size_of_element), all - done);
        std::memcpy(first + done, first, next);
        done += next;
      }
    }
    size_ = size;
  }

  char* bytes() const { return static_cast<char*>(place_); }

  void* place_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

// Whether values of the type are copied as bytes, and can be anywhere in memory. Scalars of users are among the types.
template <class T>
inline constexpr bool is_plain =
  std::conjunction_v<std::is_trivially_copyable<T>,
                     std::is_copy_constructible<T>,
                     std::is_copy_assignable<T>> && alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__;

// A std::vector of elements that are copied as bytes. It does the same, and takes a third of the time to compile:
// dozens of types of elements, most of them numbers with a tag, have been a quarter of the time that compiling a small
// program takes.
template <class T>
class Plain_vector : private Plain_storage
{
  static_assert(is_plain<T>);

public:
  typedef T value_type;
  typedef T& reference;
  typedef const T& const_reference;
  typedef T* iterator;
  typedef const T* const_iterator;

  Plain_vector() = default;
  explicit Plain_vector(std::size_t size) { resize(size); }
  Plain_vector(std::size_t size, const T& element) { resize(size, element); }
  Plain_vector(std::initializer_list<T> elements) { append(elements.begin(), elements.end()); }
  template <class Iterator, class = typename std::iterator_traits<Iterator>::iterator_category>
  Plain_vector(Iterator first, Iterator last)
  {
    reserve(static_cast<std::size_t>(std::distance(first, last)));
    for(; first != last; ++first)
      push_back(*first);
  }
  Plain_vector(const Plain_vector& other) { append(other.begin(), other.end()); }
  Plain_vector(Plain_vector&& other) noexcept { swap(other); }
  Plain_vector& operator=(Plain_vector other) noexcept
  {
    swap(other);
    return *this;
  }

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }

  T* data() { return static_cast<T*>(place_); }
  const T* data() const { return static_cast<const T*>(place_); }
  iterator begin() { return static_cast<T*>(place_); }
  iterator end() { return static_cast<T*>(place_) + size_; }
  const_iterator begin() const { return static_cast<const T*>(place_); }
  const_iterator end() const { return static_cast<const T*>(place_) + size_; }

  T& operator[](std::size_t i) { return static_cast<T*>(place_)[i]; }
  const T& operator[](std::size_t i) const { return static_cast<const T*>(place_)[i]; }
  T& front() { return *static_cast<T*>(place_); }
  const T& front() const { return *static_cast<const T*>(place_); }
  T& back() { return static_cast<T*>(place_)[size_ - 1]; }
  const T& back() const { return static_cast<const T*>(place_)[size_ - 1]; }

  void push_back(const T& element)
  {
    const T copy = element; // It can be an element of this.
    if(size_ == capacity_)
      grow(1, sizeof(T));
    ::new(static_cast<T*>(place_) + size_) T(copy);
    ++size_;
  }
  void pop_back() { --size_; }
  void append(const T* first, const T* last)
  {
    Plain_storage::append(first, static_cast<std::size_t>(last - first), sizeof(T));
  }
  iterator erase(iterator first, iterator last)
  {
    size_ = static_cast<std::size_t>(std::copy(last, end(), first) - begin());
    return first;
  }
  void clear() { size_ = 0; }

  void reserve(std::size_t capacity) { Plain_storage::reserve(capacity, sizeof(T)); }
  void resize(std::size_t size) { resize(size, T()); }
  void resize(std::size_t size, const T& element)
  {
    const T copy = element;
    Plain_storage::resize(size, std::addressof(copy), sizeof(T));
  }
  void assign(std::size_t size, const T& element)
  {
    const T copy = element;
    size_ = 0;
    Plain_storage::resize(size, std::addressof(copy), sizeof(T));
  }
};

// A Plain_vector where the elements allow it. std::vector<bool> is smaller.
template <class T>
using Vector_of = std::conditional_t<is_plain<T> && !std::is_same_v<T, bool>, Plain_vector<T>, std::vector<T>>;

// A vector whose elements are named by indices of one kind.
template <class Key, class T>
class Indexed_vector : public Vector_of<T>
{
  typedef Vector_of<T> Base;

public:
  using typename Base::const_reference;
  using typename Base::reference;

  using Base::Base;
  using Base::size;

  reference operator[](Key key) { return Base::operator[](number_of(key)); }
  const_reference operator[](Key key) const { return Base::operator[](number_of(key)); }

  // Replaces the content, which takes less time to compile than to resize, which keeps it.
  void reset(std::size_t new_size) { *this = Indexed_vector(new_size); }
  void reset(std::size_t new_size, const T& value) { *this = Indexed_vector(new_size, value); }

  bool contains(Key key) const { return number_of(key) < size(); }

  // The key of the element that push_back() adds next, and of the last one.
  Key end_key() const { return Key(size()); }
  Key last_key() const { return Key(size() - 1); }

  Index_range<Key> keys() const { return Index_range<Key>(size()); }
};

// A set of indices below a bound, one bit for each, that tells the rank of an index in it.
template <class Key>
class Index_set
{
public:
  struct Rank_tag;
  typedef Index_of<Rank_tag> Rank_index;

  typedef std::uint64_t Word;
  static constexpr std::size_t bits_per_word = 64;

  explicit Index_set(std::size_t bound) : words_(bound / bits_per_word + 1, 0) {}

  // Indices in different words can be added from different threads.
  void add(Key key) { words_[word_of(key)] |= Word(1) << bit_of(key); }

  // Ranks can be asked for after this call, and no index added.
  void count_ranks()
  {
    ranks_.resize(words_.size());
    Index rank = 0;
    for(std::size_t i = 0; i != words_.size(); ++i)
    {
      ranks_[i] = rank;
      rank += count(words_[i]);
    }
    size_ = rank;
  }

  Index size() const { return size_; }

  // How many lower indices are in the set: the name of one that is in it.
  Rank_index rank(Key key) const
  {
    const Word lower_bits = (Word(1) << bit_of(key)) - 1;
    return Rank_index(ranks_[word_of(key)] + count(words_[word_of(key)] & lower_bits));
  }

  // Calls visit(index) in ascending order.
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    for(std::size_t i = 0; i != words_.size(); ++i)
    {
      for(Word word = words_[i]; word != 0; word &= word - 1)
        visit(Key(i * bits_per_word + count((word & (~word + 1)) - 1)));
    }
  }

private:
  static std::size_t word_of(Key key) { return key.number() / bits_per_word; }
  static Index bit_of(Key key) { return key.number() % bits_per_word; }
  static Index count(Word word) { return static_cast<Index>(std::bitset<bits_per_word>(word).count()); }

  Plain_vector<Word> words_;
  Plain_vector<Index> ranks_; // by word
  Index size_ = 0;
};

// The root of the set of an element, where parent(element) is a reference to the element that it has been linked to:
// itself at the root. Paths are halved on the way.
template <class Element, class Parent>
Element find_root(Element element, const Parent& parent)
{
  while(parent(element) != element)
    element = parent(element) = parent(parent(element));
  return element;
}

// Disjoint sets of indices. The root of a set stands for all of it.
template <class Element>
class Disjoint_sets
{
public:
  explicit Disjoint_sets(Index size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), Element(0)); }

  Element find(Element element)
  {
    return find_root(element, [&](Element i) -> Element& { return parents_[i]; });
  }

  // Joins two sets, given by their roots; `root` is the root of both then.
  void link(Element old_root, Element root) { parents_[old_root] = root; }

  // Joins the sets of two elements. Returns whether they were two.
  bool unite(Element a, Element b)
  {
    const Element root_of_a = find(a), root_of_b = find(b);
    link(root_of_a, root_of_b);
    return root_of_a != root_of_b;
  }

  // The roots of the sets, by element. The sets are gone then.
  Indexed_vector<Element, Element> take_roots()
  {
    for(Element& parent : parents_)
      parent = find(parent);
    return std::move(parents_);
  }

private:
  Indexed_vector<Element, Element> parents_;
};

struct Component_tag;
typedef Index_of<Component_tag> Component_index;

// The components of sublevel or superlevel sets that merge in a sweep: disjoint sets, each with a top, the node at
// which the sweep has met it last. Both in one place, as a sweep jumps about in memory.
template <class Node>
class Merging_components
{
public:
  Index size() const { return static_cast<Index>(components_.size()); }

  // Adds a component of which `node` is all.
  Component_index add(Node node)
  {
    components_.push_back({components_.end_key(), node});
    return components_.last_key();
  }

  Component_index find(Component_index component)
  {
    return find_root(component, [&](Component_index i) -> Component_index& { return components_[i].parent; });
  }

  // Joins two components, given by their roots; `root` is the root of both then, and its top is that of both.
  void link(Component_index old_root, Component_index root) { components_[old_root].parent = root; }

  Node top(Component_index root) const { return components_[root].top; }
  void set_top(Component_index root, Node node) { components_[root].top = node; }

  // Fetches a component ahead of find(). Any index is allowed.
  void prefetch(Component_index component) const { prefetch_element(components_, component); }

private:
  struct Component
  {
    Component_index parent;
    Node top;
  };

  Indexed_vector<Component_index, Component> components_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_ARRAYS_H
