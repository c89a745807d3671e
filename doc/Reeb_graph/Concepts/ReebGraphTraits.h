/*!
\ingroup PkgReebGraphConcepts
\cgalConcept

The concept `ReebGraphTraits` describes the types of a Reeb graph, and the predicates by which
`CGAL::compute_reeb_graph()` orders the scalar values. This function asks nothing else of a scalar value: there is no
arithmetic, and no conversion to a floating point number. If it works in parallel, values are copied and compared by
several threads at once. Other functions convert number types to `double` and back. Values that are no numbers they
convert as the refinements `ReebGraphNumberTraits` and `ReebGraphInverseNumberTraits` say.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Reeb_graph_traits}
\cgalHasModels{CGAL::Reeb_graph_soup_traits}
\cgalHasModelsEnd
*/
class ReebGraphTraits
{
public:
  /// \name Types
  /// @{

  /// The type of the mesh, a model of `FaceListGraph`; any type if the graph is that of a soup.
  typedef unspecified_type Triangle_mesh;

  /// The type of the scalar field, a model of `ReadablePropertyMap` with the vertex descriptors of `Triangle_mesh` as
  /// key type, and a value type that converts to `Scalar`.
  typedef unspecified_type Scalar_map;

  /// The type of a scalar value: default constructible, copyable, ordered by `Less_scalar`.
  typedef unspecified_type Scalar;

  /// The property of a node, with the members `vertex`, `value` and `kind` of `CGAL::Reeb_graph::Node`.
  typedef unspecified_type Node;

  /// The property of an arc, with the member `chain` of `CGAL::Reeb_graph::Arc`.
  typedef unspecified_type Arc;

  /// The Reeb graph: a `boost::adjacency_list` that is `boost::bidirectionalS`, stores vertices by `boost::vecS` and
  /// edges such that they can be parallel, by `boost::vecS` for example, and has `Node` and `Arc` as properties.
  typedef unspecified_type Graph;

  /// A function object with `bool operator()(const Scalar& a, const Scalar& b) const`, a strict weak order of the
  /// values for which `Is_ordered` holds.
  typedef unspecified_type Less_scalar;

  /// A function object with `bool operator()(const Scalar& a) const` that returns `false` for a value that has no
  /// place in the order, such as NaN.
  typedef unspecified_type Is_ordered;

  /// @}

  /// \name Operations
  /// @{

  /// returns the order.
  Less_scalar less_scalar_object() const;

  /// returns the test.
  Is_ordered is_ordered_object() const;

  /// @}
};
