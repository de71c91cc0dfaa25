// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SERVING__IDLER_IMPL_HPP_
#define SERVING__IDLER_IMPL_HPP_

#include "serving/idler_interface.hpp"

namespace serving
{

/// The logic of idler.
///
/// This file is yours: idler_interface.hpp says what the logic can use.
/// ROS calls each callback in a thread of its own: guard with a mutex what they share.
class IdlerImpl
{
public:
  /// Keep what the logic may use at any time.
  explicit IdlerImpl(
    const IdlerPassthrough & passthrough);

  /// Prepare for work; return false to refuse the configuration.
  bool configure(
    const IdlerConfig & config);

  // End of life
  /// Let go of what configure took.
  void cleanup();

private:
  IdlerPassthrough passthrough_;
};

}  // namespace serving

#endif  // SERVING__IDLER_IMPL_HPP_
