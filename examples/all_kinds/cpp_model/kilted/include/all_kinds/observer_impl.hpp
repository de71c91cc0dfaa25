// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__OBSERVER_IMPL_HPP_
#define ALL_KINDS__OBSERVER_IMPL_HPP_

#include "all_kinds/observer_interface.hpp"

namespace all_kinds
{

/// The logic of observer.
///
/// This file is yours: observer_interface.hpp says what the logic can use.
/// ROS calls each callback in a thread of its own: guard with a mutex what they share.
class ObserverImpl
{
public:
  /// Keep what the logic may use at any time.
  explicit ObserverImpl(
    const ObserverPassthrough & passthrough);

  /// Prepare for work; return false to refuse the configuration.
  bool configure(
    const ObserverConfig & config);

  /// Turn the latest inputs into outputs, once in every cycle.
  void update(
    ObserverData & data,
    const ObserverConfig & config);

  // End of life
  /// Let go of what configure took.
  void cleanup();

private:
  ObserverPassthrough passthrough_;
};

}  // namespace all_kinds

#endif  // ALL_KINDS__OBSERVER_IMPL_HPP_
