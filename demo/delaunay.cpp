// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Input_mesh.h"
#include "Mesh_writer.h"
#include "Output.h"
#include "Progress_bar.h"
#include "Statistics.h"
#include "sharp_edges.h"
#include "subdivision_mesh.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/io.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>

#include <functional>
#include <iostream>
#include <optional>
#include <sstream>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// Shows the flips while they are made.
struct Flip_counter
{
  Progress_bar& progress;

  void after_flip(IT::Halfedge_index) { progress.step(); }
};

Mesh_format output_format(const Delaunay_options& options)
{
  return mesh_format(options.output == "-"
                       ? options.format
                       : std::filesystem::path(options.output).extension().string());
}

// The stages of the command, in their order.
class Delaunay_command
{
  using Edge_bool_map = Mesh::Property_map<Mesh::Edge_index, bool>;
  using Edge_length_map = Mesh::Property_map<Mesh::Edge_index, double>;

public:
  explicit Delaunay_command(const Delaunay_options& options)
    : m_options(options),
      m_format(output_format(options)),
      m_output(options.input, {options.output, options.save, options.statistics}),
      m_progress(5, options.is_quiet)
  {}

  void run()
  {
    read();
    timed("build", [this] { build(); });
    timed("flip", [this] { flip(); });
    subdivide();
    timed("write", [this] { write(); });
    finish();
  }

private:
  template <class Stage>
  void timed(const char* name, const Stage& stage)
  {
    m_progress.start_stage(name);
    const Stopwatch watch;
    stage();
    m_seconds[name] = watch.seconds();
  }

  // Has no progress bar: repairs and notes are told meanwhile.
  void read()
  {
    const Stopwatch watch;
    m_input = read_input(m_options.input, {m_options.is_repair_wanted, m_options.mollification > 0},
                         m_options.is_quiet);
    m_seconds["read"] = watch.seconds();
    m_statistics = common_statistics("delaunay", m_options.input, m_input.diagnosis);
    for(const auto& [what, count] : m_input.repairs)
      m_statistics["repairs"][what] = count;
  }

  Edge_bool_map constrained_edges()
  {
    if(m_options.constrained_angle > 0)
      return mark_sharp_edges(m_input.mesh, m_options.constrained_angle);
    return m_input.mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  }

  // With the length that was added to each edge in the statistics.
  Edge_length_map mollified_lengths()
  {
    Mesh& mesh = m_input.mesh;
    auto lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
    IT::compute_edge_lengths(mesh, lengths);
    m_statistics["added_length"] = IT::mollify(mesh, lengths, m_options.mollification);
    return lengths;
  }

  void build()
  {
    const auto np = CGAL::parameters::edge_is_constrained_map(constrained_edges());
    if(m_options.mollification > 0)
      m_triangulation.emplace(m_input.mesh,
                              IT::parameters::edge_length_map(mollified_lengths(), np));
    else
      m_triangulation.emplace(m_input.mesh, np);
  }

  void flip()
  {
    Flip_counter counter{m_progress};
    m_statistics["flips"] =
      IT::make_Delaunay(*m_triangulation, CGAL::parameters::visitor(std::ref(counter)));
  }

  void subdivide()
  {
    std::optional<IT::Correspondence<>> correspondence;
    timed("trace", [&] { correspondence.emplace(*m_triangulation); });
    timed("subdivide", [&] {
      m_subdivision.emplace(*correspondence);
      IT::interpolate(IT::Side::input, *m_subdivision, *m_triangulation, m_input.mesh.points(),
                      m_subdivision->mesh().points());
    });
    describe_triangulation(*correspondence);
  }

  void describe_triangulation(const IT::Correspondence<>& correspondence)
  {
    const IT::Delta_complex& mesh = m_triangulation->mesh();
    std::size_t shared = 0;
    double length = 0;
    for(const IT::Edge_index e : mesh.edges()) {
      shared += correspondence.is_shared(IT::Side::intrinsic, e) ? 1 : 0;
      length += m_triangulation->length(e);
    }
    const auto lengths = IT::parameters::edge_length_map(m_triangulation->length_map());
    m_statistics["is_delaunay"] = IT::is_Delaunay(*m_triangulation);
    m_statistics["shared_edges"] = shared;
    m_statistics["crossings"] = correspondence.number_of_crossings();
    m_statistics["edge_length_sum"] = length;
    m_statistics["min_angle_degrees"] = IT::diagnose(mesh, lengths).statistics().min_angle;
    const Mesh& subdivision = m_subdivision->mesh();
    m_statistics["subdivision"] = {{"vertices", subdivision.number_of_vertices()},
                                   {"edges", subdivision.number_of_edges()},
                                   {"faces", subdivision.number_of_faces()}};
  }

  void write()
  {
    m_output.add(m_options.output, text_of(subdivision_mesh(*m_subdivision), m_format));
    std::ostringstream text;
    if(!m_options.save.empty())
      IT::write_intrinsic_triangulation(text, *m_triangulation);
    m_output.add(m_options.save, text.str());
  }

  void finish()
  {
    m_statistics["seconds"] = m_seconds;
    m_statistics["peak_memory_bytes"] = peak_memory_in_bytes();
    m_output.add(m_options.statistics, text_of(m_statistics));
    m_progress.clear();
    m_output.commit();
    if(!m_options.is_quiet)
      print_summary();
  }

  void print_summary() const
  {
    const Statistics& s = m_statistics;
    std::cerr << m_options.input << ": " << s["flips"] << " flips, smallest angle "
              << m_input.diagnosis.statistics().min_angle << " -> "
              << s["min_angle_degrees"].get<double>() << " degrees, " << s["crossings"]
              << " crossings, " << s["subdivision"]["faces"]
              << " faces in the common subdivision\n";
  }

  const Delaunay_options& m_options;
  Mesh_format m_format;
  Output m_output;
  Progress_bar m_progress;
  Statistics m_statistics;
  Statistics m_seconds;
  Input_mesh m_input;
  std::optional<IT::Intrinsic_triangulation<>> m_triangulation;
  std::optional<Subdivision> m_subdivision;
};

} // namespace

int delaunay(const Delaunay_options& options)
{
  Delaunay_command(options).run();
  return 0;
}
