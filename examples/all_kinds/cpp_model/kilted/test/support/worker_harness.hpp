// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SUPPORT__WORKER_HARNESS_HPP_
#define SUPPORT__WORKER_HARNESS_HPP_

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "./fakes.hpp"
#include "all_kinds/worker_impl.hpp"

namespace all_kinds
{

/// The logic of worker, fakes in the place of ROS, and a clock.
///
/// With messages received, a cycle is `harness.in_NAME(message).run_cycle().out_NAME`.
struct WorkerHarness
{
  /// Create the publishers for the topics that the parameters have.
  explicit WorkerHarness(const WorkerConfig & given = WorkerConfig())
  : config(given)
  {
  }

  WorkerHarness(const WorkerHarness &) = delete;
  WorkerHarness & operator=(const WorkerHarness &) = delete;

  /// Pass a message to the next cycle.
  WorkerHarness & in_speed(
    const worker_types::InSpeed & message)
  {
    data.in_speed = message;
    data.in_speed_updated = true;
    return *this;
  }

  /// Pass a message to the next cycle.
  WorkerHarness & in_counter(
    const worker_types::InCounter & message)
  {
    data.in_counter = message;
    data.in_counter_updated = true;
    return *this;
  }

  /// Run one cycle as the node does.
  const WorkerData & run_cycle()
  {
    data.out_counter_active = true;
    data.out_status_active = true;
    impl.update(data, config);
    data.in_speed_updated = false;
    data.in_counter_updated = false;
    return data;
  }

  Time time;
  bool stopped = false;
  std::vector<std::string> log;
  std::vector<std::string> failures;
  WorkerConfig config;
  WorkerData data;
  WorkerPassthrough passthrough = connected();
  std::shared_ptr<LogicStatus> diagnostics = passthrough.diagnostics;
  std::shared_ptr<FakePublisher<worker_types::PubEcho>> pub_echo =
    fake<FakePublisher>(passthrough.pub_echo);
  std::shared_ptr<FakePublisher<worker_types::PubEmpty>> pub_empty =
    fake<FakePublisher>(passthrough.pub_empty);
  std::map<std::string, std::shared_ptr<FakePublisher<worker_types::PubAnswer>>> pub_answer =
    fake_each(passthrough.pub_answer, config.answer_topics);
  std::shared_ptr<FakeServiceClient<worker_types::ClientPermit>> client_permit =
    fake<FakeServiceClient>(passthrough.client_permit);
  std::shared_ptr<FakeActionClient<worker_types::ActionDelegate>> action_delegate =
    fake<FakeActionClient>(passthrough.action_delegate);
  std::shared_ptr<FakeTransformListener<worker_types::Transform>> listener_frames =
    fake<FakeTransformListener>(passthrough.listener_frames);
  std::shared_ptr<FakeTransformBroadcaster<worker_types::Transform>> broadcaster_pose =
    fake<FakeTransformBroadcaster>(passthrough.broadcaster_pose);
  WorkerImpl impl{passthrough};

private:
  WorkerPassthrough connected()
  {
    WorkerPassthrough passthrough;
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

#endif  // SUPPORT__WORKER_HARNESS_HPP_
