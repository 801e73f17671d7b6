// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FIXED_POINT_ACCELERATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FIXED_POINT_ACCELERATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <cstddef>
#include <deque>

namespace CGAL::Discrete_conformal_maps::internal {

// Finds a fixed point of a function in fewer evaluations than by iteration. A step leads to the
// fixed point of the linear function through the last evaluations (Anderson acceleration).
class Fixed_point_acceleration
{
public:
  typedef Eigen::VectorXd Vector;

  // Returns whether the function has been evaluated, and the best argument.
  bool has_best() const { return m_image.size() > 0; }
  Vector best() const { return m_image - m_residual; }

  // Returns the next argument of the function, whose value at `x` is `image`. The sum of entries is
  // the sum of the entries of the images.
  Vector next(const Vector& x, const Vector& image)
  {
    remember(image, image - x);
    if(m_image_steps.empty())
      return image;
    const auto n = static_cast<Eigen::Index>(m_image_steps.size());
    Eigen::MatrixXd image_steps(x.size(), n), residual_steps(x.size(), n);
    for(Eigen::Index i = 0; i < n; ++i) {
      image_steps.col(i) = m_image_steps[static_cast<std::size_t>(i)];
      residual_steps.col(i) = m_residual_steps[static_cast<std::size_t>(i)];
    }
    return m_image - image_steps * residual_steps.colPivHouseholderQr().solve(m_residual);
  }

private:
  static constexpr std::size_t memory = 5;

  void remember(const Vector& image, const Vector& residual)
  {
    if(m_image.size() > 0) {
      m_image_steps.push_back(image - m_image);
      m_residual_steps.push_back(residual - m_residual);
      if(m_image_steps.size() > memory) {
        m_image_steps.pop_front();
        m_residual_steps.pop_front();
      }
      if(!(residual.norm() < m_residual.norm()))
        return;
    }
    m_image = image;
    m_residual = residual;
  }

  // Stores differences of images and residuals to the best ones before.
  std::deque<Vector> m_image_steps, m_residual_steps;
  Vector m_image, m_residual; // the best ones
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FIXED_POINT_ACCELERATION_H
