// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DRAW_INTRINSIC_TRIANGULATION_H
#define CGAL_DRAW_INTRINSIC_TRIANGULATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>

#ifdef CGAL_USE_BASIC_VIEWER

#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Qt/init_ogl_context.h>

#endif

#if defined(CGAL_USE_BASIC_VIEWER) || defined(DOXYGEN_RUNNING)

namespace CGAL {

namespace Intrinsic_triangulations::internal {

// Faces of T2 have colors; its edges are red, those of T1 gray.
template <typename Subdivision>
class Subdivision_viewer_qt : public Basic_viewer_qt
{
public:
  Subdivision_viewer_qt(const Subdivision& subdivision, const char* title, bool nofill)
    : Basic_viewer_qt(nullptr, title, false, true, !nofill, false, false)
  {
    this->m_size_edges = 1.5;
    const auto& mesh = subdivision.mesh();
    if(!nofill)
      for(Face_index f : mesh.faces()) {
        this->face_begin(light_color(subdivision.parent_face(Side::intrinsic, f)));
        for(Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
          this->add_point_in_face(mesh.point(v));
        this->face_end();
      }
    for(Edge_index e : mesh.edges())
      this->add_segment(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)),
                        subdivision.parent_edge(Side::intrinsic, e).is_valid()
                          ? IO::Color(200, 80, 30)
                          : IO::Color(135, 149, 163));
  }

private:
  static IO::Color light_color(Face_index f)
  {
    Random random(f.idx());
    const auto channel = [&] { return static_cast<unsigned char>(random.get_int(150, 250)); };
    return {channel(), channel(), channel()};
  }
};

} // namespace Intrinsic_triangulations::internal

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// opens a new window and draws \f$T_2\f$ on the surface of \f$T_1\f$: the faces of the common
/// subdivision with a color for each face of \f$T_2\f$, the edges of \f$T_2\f$ in red over those of
/// \f$T_1\f$ in gray. It returns when the user closes the window. As other functions `draw()` of
/// CGAL it requires `CGAL_Qt5`, and is only available if the macro `CGAL_USE_BASIC_VIEWER` is
/// defined, which the CMake target `CGAL::CGAL_Basic_viewer` does; so far with CGAL 5.
///
/// \param tri the triangulation
/// \param positions a readable property map from the vertices of \f$T_1\f$ to points of a kernel
/// \param title the title of the window
/// \param nofill whether only edges are drawn
/// \pre \f$T_2\f$ has no garbage
template <typename Traits, typename PointMap>
void draw(const Intrinsic_triangulations::Intrinsic_triangulation<Traits>& tri,
          const PointMap& positions, const char* title = "Intrinsic Triangulation Basic Viewer",
          bool nofill = false)
{
  namespace IT = Intrinsic_triangulations;
  typedef IT::Common_subdivision<Traits, typename boost::property_traits<PointMap>::value_type>
    Subdivision;
  const IT::Correspondence<Traits> correspondence(tri);
  Subdivision subdivision(correspondence);
  IT::interpolate(IT::Side::input, subdivision, positions, subdivision.mesh().points());
  if(qEnvironmentVariableIsSet("CGAL_TEST_SUITE"))
    return;
  Qt::init_ogl_context(4, 3);
  int argc = 1;
  const char* argv[] = {"intrinsic_triangulation_viewer", nullptr};
  QApplication app(argc, const_cast<char**>(argv));
  IT::internal::Subdivision_viewer_qt<Subdivision> window(subdivision, title, nofill);
  window.show();
  app.exec();
}

} // namespace CGAL

#endif

#endif // CGAL_DRAW_INTRINSIC_TRIANGULATION_H
