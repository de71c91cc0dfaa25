// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef DRIVER__REPLAY_IMPL_HPP_
#define DRIVER__REPLAY_IMPL_HPP_

#include "driver/replay_interface.hpp"

namespace driver
{

/// The logic of replay.
///
/// Edit this file: replay_interface.hpp declares what the logic can use.
class ReplayImpl
{
public:
  /// Store the passthrough.
  explicit ReplayImpl(
    const ReplayPassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const ReplayConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  // Timer play
  /// Do what is due, in a thread of its own.
  void play();

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  ReplayPassthrough passthrough_;
};

}  // namespace driver

#endif  // DRIVER__REPLAY_IMPL_HPP_
