// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef CONTROLLER_HARNESS_HPP_
#define CONTROLLER_HARNESS_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "driving/controller_impl.hpp"

namespace driving
{

/// The logic of controller, fakes in the place of ROS, and a clock.
///
/// With messages received, a cycle is `harness.in_NAME(message).run_cycle().out_NAME`.
struct ControllerHarness
{
  ControllerHarness()
  : impl(connected())
  {
  }

  ControllerHarness(const ControllerHarness &) = delete;

  /// Pass a message to the next cycle.
  ControllerHarness & in_target_speed(
    const controller_types::InTargetSpeed & message)
  {
    data.in_target_speed = message;
    data.in_target_speed_updated = true;
    return *this;
  }

  /// Run one cycle as the node does.
  const ControllerData & run_cycle()
  {
    data.out_speed_active = true;
    impl.update(data, config);
    data.in_target_speed_updated = false;
    return data;
  }

  Time time;
  bool stopped = false;
  std::vector<std::string> log;
  ControllerConfig config;
  ControllerData data;
  ControllerPassthrough passthrough;
  ControllerImpl impl;

private:
  const ControllerPassthrough & connected()
  {
    passthrough.log = Logger(
      [this](Logger::Level, const std::string & text, const Logger::Place &) {
        log.push_back(text);
      });
    passthrough.now = [this] {return time;};
    passthrough.sleep = [this](double seconds) {
        if (!stopped) {
          time = Time(time.nanoseconds() + static_cast<std::int64_t>(seconds * 1e9));
        }
        return !stopped;
      };
    return passthrough;
  }
};

}  // namespace driving

#endif  // CONTROLLER_HARNESS_HPP_
