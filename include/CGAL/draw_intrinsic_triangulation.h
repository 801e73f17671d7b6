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

#include <CGAL/IO/Color.h>
#include <CGAL/Random.h>
#include <CGAL/version.h>

#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/Graphics_scene.h>
#endif
#ifdef CGAL_USE_BASIC_VIEWER
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/Qt/Basic_viewer.h>
#else
#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Qt/init_ogl_context.h>
#endif
#endif

namespace CGAL {

namespace Intrinsic_triangulations::internal {

inline IO::Color light_color(Face_index f)
{
  Random random(f.idx());
  const auto channel = [&] { return static_cast<unsigned char>(random.get_int(150, 250)); };
  return {channel(), channel(), channel()};
}

// Adds T2 on the surface of T1 to a `Graphics_scene` of CGAL 6 or a `Basic_viewer_qt` of CGAL 5.
template <typename Traits, typename PointMap, typename Scene>
void add_to_scene(const Intrinsic_triangulation<Traits>& tri, const PointMap& positions,
                  bool nofill, Scene& scene)
{
  const Correspondence<Traits> correspondence(tri);
  Common_subdivision<Traits, typename boost::property_traits<PointMap>::value_type> subdivision(
    correspondence);
  auto& mesh = subdivision.mesh();
  interpolate(Side::input, subdivision, positions, mesh.points());
  if(!nofill)
    for(Face_index f : mesh.faces()) {
      scene.face_begin(light_color(subdivision.parent_face(Side::intrinsic, f)));
      for(Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        scene.add_point_in_face(mesh.point(v));
      scene.face_end();
    }
  for(Edge_index e : mesh.edges())
    scene.add_segment(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)),
                      subdivision.parent_edge(Side::intrinsic, e).is_valid()
                        ? IO::Color(200, 80, 30)
                        : IO::Color(135, 149, 163));
}

} // namespace Intrinsic_triangulations::internal

#if CGAL_VERSION_MAJOR >= 6 || defined(DOXYGEN_RUNNING)

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// adds \f$T_2\f$ on the surface of \f$T_1\f$ to `scene`. Faces of the common subdivision have a
/// color for each face of \f$T_2\f$. Edges of \f$T_2\f$ are red, over gray edges of \f$T_1\f$. It
/// needs CGAL 6 or later. Complexity: linear in the size of the common subdivision.
///
/// \param tri the triangulation
/// \param positions a readable property map from the vertices of \f$T_1\f$ to points of a kernel
/// \param scene the scene
/// \param nofill whether only edges are added
/// \pre \f$T_2\f$ has no garbage
template <typename Traits, typename PointMap>
void add_to_graphics_scene(const Intrinsic_triangulations::Intrinsic_triangulation<Traits>& tri,
                           const PointMap& positions, Graphics_scene& scene, bool nofill = false)
{
  Intrinsic_triangulations::internal::add_to_scene(tri, positions, nofill, scene);
}

#endif

#if defined(CGAL_USE_BASIC_VIEWER) || defined(DOXYGEN_RUNNING)

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// opens a new window and draws \f$T_2\f$ on the surface of \f$T_1\f$, as
/// `add_to_graphics_scene()` does. It returns when the user closes the window. As other functions
/// `draw()` of CGAL it requires `CGAL_Qt6` (`CGAL_Qt5` with CGAL 5). It is only available if the
/// macro `CGAL_USE_BASIC_VIEWER` is defined, which the CMake target `CGAL::CGAL_Basic_viewer`
/// does. Complexity: the complexity of `add_to_graphics_scene()`.
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
#if CGAL_VERSION_MAJOR >= 6
  Graphics_scene scene;
  add_to_graphics_scene(tri, positions, scene, nofill);
  draw_graphics_scene(scene, title);
#else
  if(qEnvironmentVariableIsSet("CGAL_TEST_SUITE"))
    return;
  Qt::init_ogl_context(4, 3);
  int argc = 1;
  const char* argv[] = {"intrinsic_triangulation_viewer", nullptr};
  QApplication app(argc, const_cast<char**>(argv));
  Basic_viewer_qt window(nullptr, title, false, true, !nofill, false, false);
  Intrinsic_triangulations::internal::add_to_scene(tri, positions, nofill, window);
  window.show();
  app.exec();
#endif
}

#endif

} // namespace CGAL

#endif // CGAL_DRAW_INTRINSIC_TRIANGULATION_H
