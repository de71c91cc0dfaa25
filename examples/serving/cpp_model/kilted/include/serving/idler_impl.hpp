// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SERVING__IDLER_IMPL_HPP_
#define SERVING__IDLER_IMPL_HPP_

#include "serving/idler_interface.hpp"

namespace serving
{

/// The logic of idler.
///
/// Edit this file: idler_interface.hpp declares what the logic can use.
class IdlerImpl
{
public:
  /// Store the passthrough.
  explicit IdlerImpl(
    const IdlerPassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const IdlerConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  IdlerPassthrough passthrough_;
};

}  // namespace serving

#endif  // SERVING__IDLER_IMPL_HPP_
