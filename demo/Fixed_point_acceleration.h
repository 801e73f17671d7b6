// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FIXED_POINT_ACCELERATION_H
#define INTRINSIC_FIXED_POINT_ACCELERATION_H

#include <Eigen/Core>

#include <cstddef>
#include <deque>

// Finds a fixed point of a function in fewer evaluations than by repeating it: goes to where the
// last ones, seen as those of a linear function, say that it is (Anderson's method).
class Fixed_point_acceleration
{
  using Vector = Eigen::VectorXd;

public:
  // Where to evaluate the function after its value at `x` is `image`. The sum of entries is that of
  // the images.
  Vector next(const Vector& x, const Vector& image);

private:
  static constexpr std::size_t memory = 5;

  void remember(const Vector& image, const Vector& residual);

  // differences of images, and of how far they are from their arguments, one after the other
  std::deque<Vector> m_image_steps, m_residual_steps;
  Vector m_image, m_residual;
};

#endif // INTRINSIC_FIXED_POINT_ACCELERATION_H
