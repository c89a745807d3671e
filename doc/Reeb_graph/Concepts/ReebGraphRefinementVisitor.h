/*!
\ingroup PkgReebGraphConcepts
\cgalConcept

The concept `ReebGraphRefinementVisitor` describes what the functions that refine a mesh, such as
`CGAL::Reeb_graph::cut_along_contours()`, tell while they work, so that attributes of the mesh can be carried over.

The refinement is a sequence of single steps: the split of an edge, or of a face. After each, the members
are called, and the mesh can be read; its faces are no triangles all the time. An exception that a member throws can
leave the mesh partly refined. If the named parameter `callback` stops the work, splits are undone, which is not told.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Reeb_graph::Default_refinement_visitor}
\cgalHasModels{CGAL::Reeb_graph::Interpolating_visitor}
\cgalHasModelsEnd
*/
class ReebGraphRefinementVisitor
{
public:
  /// is called when the halfedge `first` has been split off from `second`, which it leads to.
  void edge_split(halfedge_descriptor first, halfedge_descriptor second);

  /// is called when `v` has been placed at the fraction `t` of the way from `source` to `target`, which are vertices of
  /// the mesh as it was before, or have been announced by this member.
  void vertex_added(vertex_descriptor v, vertex_descriptor source, vertex_descriptor target, double t);

  /// is called when the face `created` has been split off from `old`.
  void face_split(face_descriptor old, face_descriptor created);

  /// is called when the mesh is cut open and the lower side of a curve gets the vertex `created` in the place of `old`.
  void vertex_duplicated(vertex_descriptor old, vertex_descriptor created);

  /// is called when the mesh is cut open and the lower side of a curve gets the halfedge `created` in the place of
  /// `old`, which is on the border then.
  void halfedge_duplicated(halfedge_descriptor old, halfedge_descriptor created);
};
