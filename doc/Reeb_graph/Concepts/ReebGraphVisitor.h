/*!
\ingroup PkgReebGraphConcepts
\cgalConcept

The concept `ReebGraphVisitor` describes the functions that `CGAL::compute_reeb_graph()` calls while it works. Use them
for progress, for timing, and for the critical vertices, of which there are more than nodes.

An exception that a member throws ends the computation and reaches the caller. Unless it comes from the end of the
last stage, the graph is as it was before.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Reeb_graph::Default_visitor}
\cgalHasModelsEnd
*/
class ReebGraphVisitor
{
public:
  /// is called before each stage.
  void begin_stage(CGAL::Reeb_graph::Stage stage);

  /// is called after each stage.
  void end_stage(CGAL::Reeb_graph::Stage stage);

  /// is called once, in the stage `CGAL::Reeb_graph::Stage::CLASSIFY`.
  void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts& counts);
};
