/*!
\ingroup PkgReebGraphConcepts
\cgalConcept

\cgalRefines{ReebGraphNumberTraits}

The concept `ReebGraphInverseNumberTraits` also makes scalar values of numbers. Without it, contours are placed by the
vertices of chains, and vertices that are added to a mesh get values of others.

No class of the package is a model: derive one from `CGAL::Reeb_graph_traits`.
*/
class ReebGraphInverseNumberTraits
{
public:
  /// returns a function object with `Scalar operator()(double x) const`: for a number between those of two values, a
  /// value between these or equal to the lower one.
  unspecified_type scalar_from_double_object() const;
};
