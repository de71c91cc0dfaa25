// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef DRIVER__SENSOR_IMPL_HPP_
#define DRIVER__SENSOR_IMPL_HPP_

#include "driver/sensor_interface.hpp"

namespace driver
{

/// The logic of sensor.
///
/// Edit this file: sensor_interface.hpp declares what the logic can use.
class SensorImpl
{
public:
  /// Store the passthrough.
  explicit SensorImpl(
    const SensorPassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const SensorConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  // Thread read
  /// Do one piece of work in a thread of its own; called again, the stub once a second.
  void read();

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  SensorPassthrough passthrough_;
};

}  // namespace driver

#endif  // DRIVER__SENSOR_IMPL_HPP_
