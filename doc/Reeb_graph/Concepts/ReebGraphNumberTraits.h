/*!
\ingroup PkgReebGraphConcepts
\cgalConcept

\cgalRefines{ReebGraphTraits}

The concept `ReebGraphNumberTraits` makes numbers of scalar values. It is needed for values that are no numbers, and
takes the place of the conversions of number types. Functions that need numbers, such as those that simplify, draw,
measure and cut, use it. Without it, they do not compile, and say so. `CGAL::Reeb_graph::Augmentation` uses it for the
values of contours and the places of their points. Without it, these values are NaN, and points are in the middles of
edges. Graphs are written with numbers where values have no `operator<<`. Functions that take no mesh are given the
traits class as named parameter `geom_traits`, too.

No class of the package is a model: derive one from `CGAL::Reeb_graph_traits`.
*/
class ReebGraphNumberTraits
{
public:
  /// returns a function object with `double operator()(const Scalar& a) const`, which must not fall in the order. An
  /// order of numbers that has a table, for one, can return the places in it.
  unspecified_type scalar_to_double_object() const;
};
