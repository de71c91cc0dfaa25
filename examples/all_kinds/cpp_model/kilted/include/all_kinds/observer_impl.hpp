// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__OBSERVER_IMPL_HPP_
#define ALL_KINDS__OBSERVER_IMPL_HPP_

#include "all_kinds/observer_interface.hpp"

namespace all_kinds
{

/// The logic of observer.
///
/// Edit this file: observer_interface.hpp declares what the logic can use.
class ObserverImpl
{
public:
  /// Store the passthrough.
  explicit ObserverImpl(
    const ObserverPassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const ObserverConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  /// Compute the outputs of one cycle from the latest inputs.
  void update(
    ObserverData & data,
    const ObserverConfig & config);

  // Synchronizer pair
  /// Handle messages whose stamps belong together, in a thread of its own.
  void receive_pair(
    const observer_types::PairMessages & messages);

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  ObserverPassthrough passthrough_;
};

}  // namespace all_kinds

#endif  // ALL_KINDS__OBSERVER_IMPL_HPP_
