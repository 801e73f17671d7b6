// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Fixed_point_acceleration.h"

#include <Eigen/QR>

Eigen::VectorXd Fixed_point_acceleration::next(const Vector& x, const Vector& image)
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
  return image - image_steps * residual_steps.colPivHouseholderQr().solve(m_residual);
}

void Fixed_point_acceleration::remember(const Vector& image, const Vector& residual)
{
  const bool is_first = m_image.size() == 0;
  if(!is_first && residual.norm() < m_residual.norm()) {
    m_image_steps.push_back(image - m_image);
    m_residual_steps.push_back(residual - m_residual);
  } else { // what has led away is forgotten
    m_image_steps.clear();
    m_residual_steps.clear();
  }
  if(m_image_steps.size() > memory) {
    m_image_steps.pop_front();
    m_residual_steps.pop_front();
  }
  m_image = image;
  m_residual = residual;
}
