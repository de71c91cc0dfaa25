// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SUPPORT__RECORDER__ALL_KINDS__WORKER_IMPL_HPP_
#define SUPPORT__RECORDER__ALL_KINDS__WORKER_IMPL_HPP_

#include <atomic>
#include <chrono>
#include <iostream>
#include <string>
#include <thread>

#include "all_kinds/worker_interface.hpp"

namespace all_kinds
{

/// Stands in for the logic of worker: it writes its calls to stdout, for the test to read.
///
/// It refuses nothing, publishes every output, and fulfils every request at once.
class WorkerImpl
{
public:
  explicit WorkerImpl(
    [[maybe_unused]] const WorkerPassthrough & passthrough)
  : passthrough_(passthrough)
  {
  }

  bool configure(
    [[maybe_unused]] const WorkerConfig & config)
  {
    record("configure");
    record_changes(config);
    return true;
  }

  bool activate()
  {
    is_active_ = true;
    calling_ = std::thread([this] {call_services();});
    publish();
    updates_ = 0;
    start_ = Clock::now();
    record("activate");
    return true;
  }

  void update(
    [[maybe_unused]] WorkerData & data,
    [[maybe_unused]] const WorkerConfig & config)
  {
    if (++updates_ == 1) {
      record("update");
    }
    if (data.in_speed_updated) {
      record("in_speed");
    }
    if (data.in_counter_updated) {
      record("in_counter");
    }
    record_changes(config);
  }

  void receive_say(
    const worker_types::SayMessage & /* message */)
  {
    record("receive_say");
  }

  void serve_reset(
    const worker_types::ResetService::Request & /* request */,
    worker_types::ResetService::Response & /* response */)
  {
    record("serve_reset");
  }

  void serve_enable(
    const worker_types::EnableService::Request & /* request */,
    worker_types::EnableService::Response & /* response */)
  {
    record("serve_enable");
  }

  void execute_compute(
    Goal<worker_types::ComputeAction> & goal)
  {
    record("execute_compute");
    goal.succeed();
  }

  void deactivate()
  {
    is_active_ = false;
    calling_.join();
    const std::chrono::duration<double> seconds = Clock::now() - start_;
    record("rate " + std::to_string(updates_ / seconds.count()));
    record("deactivate");
    publish();
  }

  void cleanup() {record("cleanup");}

private:
  using Clock = std::chrono::steady_clock;

  static void record(const std::string & call)
  {
    std::cout << "called " + call + "\n" << std::flush;
  }

  /// Record the parameters that have changed; at first, those that differ from the spec.
  void record_changes(
    const WorkerConfig & config)
  {
    if (config.prefix != config_.prefix) {
      record("config.prefix");
    }
    if (config.weights != config_.weights) {
      record("config.weights");
    }
    if (config.gain != config_.gain) {
      record("config.gain");
    }
    if (config.step != config_.step) {
      record("config.step");
    }
    if (config.verbose != config_.verbose) {
      record("config.verbose");
    }
    if (config.label != config_.label) {
      record("config.label");
    }
    config_ = config;
  }

  /// Call every service, one after the other.
  void call_services()
  {
    call(*passthrough_.client_permit, "client_permit");
  }

  /// Call a service until it responds.
  template<typename Service>
  void call(ServiceClient<Service> & client, const std::string & name)
  {
    while (is_active_) {
      if (client.call(typename Service::Request())) {
        record(name);
        return;
      }
    }
  }

  /// Publish a message to every topic that the logic publishes to by itself.
  void publish()
  {
    passthrough_.pub_echo->publish(worker_types::PubEcho());
    passthrough_.pub_empty->publish(worker_types::PubEmpty());
  }

  WorkerPassthrough passthrough_;
  WorkerConfig config_;
  std::atomic<bool> is_active_{false};
  std::thread calling_;
  int updates_ = 0;
  Clock::time_point start_;
};

}  // namespace all_kinds

#endif  // SUPPORT__RECORDER__ALL_KINDS__WORKER_IMPL_HPP_
