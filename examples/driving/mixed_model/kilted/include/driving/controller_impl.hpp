// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef DRIVING__CONTROLLER_IMPL_HPP_
#define DRIVING__CONTROLLER_IMPL_HPP_

#include "driving/controller_interface.hpp"

namespace driving
{

/// The logic of controller.
///
/// Edit this file: controller_interface.hpp declares what the logic can use.
class ControllerImpl
{
public:
  /// Store the passthrough.
  explicit ControllerImpl(
    const ControllerPassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const ControllerConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  /// Compute the outputs of one cycle from the latest inputs.
  void update(
    ControllerData & data,
    const ControllerConfig & config);

  // Service stop
  /// Fill in the response, in a thread of its own.
  void serve_stop(
    const controller_types::StopService::Request & request,
    controller_types::StopService::Response & response);

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  ControllerPassthrough passthrough_;
};

}  // namespace driving

#endif  // DRIVING__CONTROLLER_IMPL_HPP_
