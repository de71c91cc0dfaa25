// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SUPPORT__OBSERVER_HARNESS_HPP_
#define SUPPORT__OBSERVER_HARNESS_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "all_kinds/observer_impl.hpp"

namespace all_kinds
{

/// The logic of observer, fakes in the place of ROS, and a clock.
///
/// With messages received, a cycle is `harness.in_NAME(message).run_cycle().out_NAME`.
struct ObserverHarness
{
  ObserverHarness() = default;
  ObserverHarness(const ObserverHarness &) = delete;
  ObserverHarness & operator=(const ObserverHarness &) = delete;

  /// Pass a message to the next cycle.
  ObserverHarness & in_status(
    const observer_types::InStatus & message)
  {
    data.in_status = message;
    data.in_status_updated = true;
    return *this;
  }

  /// Run one cycle as the node does.
  const ObserverData & run_cycle()
  {
    impl.update(data, config);
    data.in_status_updated = false;
    return data;
  }

  Time time;
  bool stopped = false;
  std::vector<std::string> log;
  std::vector<std::string> failures;
  ObserverConfig config;
  ObserverData data;
  ObserverPassthrough passthrough = connected();
  ObserverImpl impl{passthrough};

private:
  ObserverPassthrough connected()
  {
    ObserverPassthrough passthrough;
    passthrough.log = Logger(
      [this](Logger::Level, Logger::Text text, const Logger::Place &) {log.push_back(text);});
    passthrough.now = [this] {return time;};
    passthrough.sleep = [this](double seconds) {
        if (!stopped) {
          time = Time(time.nanoseconds() + static_cast<std::int64_t>(seconds * 1e9));
        }
        return !stopped;
      };
    passthrough.fail = [this](const std::string & reason) {failures.push_back(reason);};
    return passthrough;
  }
};

}  // namespace all_kinds

#endif  // SUPPORT__OBSERVER_HARNESS_HPP_
